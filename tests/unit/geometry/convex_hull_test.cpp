#include "engine/geometry/convex_hull.h"

#include "engine/geometry/polygon.h"
#include "tests/unit/geometry/shapes.h"

#include <gtest/gtest.h>

namespace hanei {
namespace {

TEST(ConvexHull, of_random_points_in_any_plane_holds_them_all_and_turns_one_way) {
    testing::Dice dice(3);
    for (int k = 0; k < 200; ++k) {
        const Mat3 frame = dice.rotation();
        std::vector<Vec3> points;
        for (int j = 0; j < 12; ++j)
            points.push_back(dice.uniform(-1, 1) * frame[0] + dice.uniform(-2, 2) * frame[1] + 5.0 * frame[2]);
        const Polygon hull = convex_hull(points, frame[2]);
        ASSERT_GE(hull.size(), 3U);
        EXPECT_TRUE(is_convex(hull, frame[2]));
        for (std::size_t c = 0; c < hull.size(); ++c) {
            const Vec3 side = hull[(c + 1) % hull.size()] - hull[c];
            for (const Vec3& point : points) EXPECT_GE(glm::dot(glm::cross(side, point - hull[c]), frame[2]), -1e-12);
        }
    }
}

TEST(ConvexHull, leaves_out_points_on_its_edges_and_repeated_ones) {
    const std::vector<Vec3> points{{0, 0, 1}, {1, 0, 1}, {2, 0, 1}, {2, 2, 1}, {0, 2, 1}, {0, 0, 1}, {1, 1, 1}};
    EXPECT_EQ(convex_hull(points, {0, 0, 1}).size(), 4U);
}

TEST(ConvexHull, of_a_line_or_less_is_empty) {
    EXPECT_TRUE(convex_hull(std::vector<Vec3>{}, {0, 0, 1}).empty());
    EXPECT_TRUE(convex_hull(std::vector<Vec3>{{0, 0, 0}, {1, 1, 0}, {2, 2, 0}, {3, 3, 0}}, {0, 0, 1}).empty());
    EXPECT_TRUE(convex_hull(std::vector<Vec3>(5, Vec3{1}), {0, 0, 1}).empty());
}

}  // namespace
}  // namespace hanei
