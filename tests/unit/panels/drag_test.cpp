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

TEST(Dragging, keeps_the_grip_where_the_object_was_taken_hold_of) {
    const Vec3 eye{0.0, -5.0, 6.0};
    const auto gesture = DragGesture::begin(ray(eye, {1.2, 1.1, 2.5}), {1.0, 1.0, 2.5}, {}, 100.0);
    ASSERT_TRUE(gesture);
    const Vec3 place = gesture->place(ray(eye, {2.2, 1.6, 2.5}), 0.0, {1.0, 1.0, 2.5});
    EXPECT_NEAR(place.x, 2.0, 1e-9);  // rounding of a ray 8 m long, divided by a sine of 0.4
    EXPECT_NEAR(place.y, 1.5, 1e-9);
    EXPECT_EQ(place.z, 2.5);
}

TEST(Dragging, by_an_arrow_changes_that_coordinate_alone) {
    const Vec3 eye{3.0, -5.0, 2.0};
    const auto gesture = DragGesture::begin(ray(eye, {1.0, 1.0, 2.5}), {1.0, 1.0, 2.0}, Axis::z, 100.0);
    ASSERT_TRUE(gesture);
    const Vec3 place = gesture->place(ray(eye, {1.0, 1.0, 3.1}), 0.0, {1.0, 1.0, 2.0});
    EXPECT_EQ(place.x, 1.0);
    EXPECT_EQ(place.y, 1.0);
    EXPECT_NEAR(place.z, 2.6, 1e-9);
}

TEST(Dragging, an_axis_seen_end_on_cannot_be_dragged) {
    EXPECT_FALSE(along_axis(ray({1.0, 1.0, 9.0}, {1.0, 1.0, 0.0}), {1.0, 1.0, 2.0}, Axis::z));
}

TEST(Dragging, keeps_to_the_raster_and_leaves_the_height_alone) {
    const Vec3 eye{0.0, -5.0, 6.0};
    const auto gesture = DragGesture::begin(ray(eye, {1.0, 1.0, 2.99}), {1.0, 1.0, 2.99}, {}, 100.0);
    ASSERT_TRUE(gesture);
    const Vec3 place = gesture->place(ray(eye, {1.533, 1.27, 2.99}), 0.1, {1.0, 1.0, 2.99});
    EXPECT_NEAR(place.x, 1.5, rounding);
    EXPECT_NEAR(place.y, 1.3, rounding);
    EXPECT_EQ(place.z, 2.99);
}

}  // namespace
}  // namespace hanei
