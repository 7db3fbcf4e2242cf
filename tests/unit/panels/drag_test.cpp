#include "ui/panels/drag.h"

#include <cmath>
#include <gtest/gtest.h>

namespace hanei {
namespace {

Ray ray(Vec3 origin, Vec3 towards) { return {origin, glm::normalize(towards - origin)}; }

constexpr double rounding = 1e-12;  // m, of a few additions at the size of a room

TEST(Dragging, a_ray_from_above_meets_the_plane_at_the_objects_height) {
    const auto met = on_horizontal_plane(ray({0.0, 0.0, 4.0}, {3.0, 1.0, 2.5}), 2.5, 100.0);
    ASSERT_TRUE(met);
    EXPECT_NEAR(met->x, 3.0, rounding);
    EXPECT_NEAR(met->y, 1.0, rounding);
    EXPECT_NEAR(met->z, 2.5, rounding);
}

TEST(Dragging, near_the_horizon_nothing_is_said_rather_than_something_wild) {
    EXPECT_FALSE(on_horizontal_plane(ray({0.0, 0.0, 2.6}, {10.0, 0.0, 2.5}), 2.5, 100.0));
    EXPECT_FALSE(on_horizontal_plane(ray({0.0, 0.0, 1.0}, {1.0, 0.0, 0.0}), 2.5, 100.0));     // looks away from it
    EXPECT_FALSE(on_horizontal_plane(ray({0.0, 0.0, 50.0}, {90.0, 0.0, 40.0}), 2.5, 100.0));  // too far
}

TEST(Dragging, an_axis_seen_end_on_cannot_be_dragged) {
    EXPECT_FALSE(along_axis(ray({1.0, 1.0, 9.0}, {1.0, 1.0, 0.0}), {1.0, 1.0, 2.0}, Axis::z));
}

}  // namespace
}  // namespace hanei
