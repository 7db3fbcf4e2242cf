#include "engine/geometry/arc_tangent.h"

#include <gtest/gtest.h>

namespace hanei {
namespace {

TEST(ArcTangent, all_around_and_at_every_size_agrees_with_the_library) {
    for (int k = 0; k < 200'000; ++k) {
        const double angle = (k + 0.3) * std::numbers::pi / 100'000 - std::numbers::pi;
        const double size = std::pow(10.0, k % 200 - 100);
        const double y = size * std::sin(angle), x = size * std::cos(angle);
        const double expected = std::atan2(y, x);
        EXPECT_NEAR(arc_tangent(y, x) / expected, 1.0, 7e-16) << angle;  // three units in the last place
    }
}

TEST(ArcTangent, small_angles_keep_their_digits) {
    for (double y = 1.0; y > 1e-100; y *= 0.37) EXPECT_NEAR(arc_tangent(y, 1.7) / std::atan2(y, 1.7), 1.0, 7e-16) << y;
}

TEST(ArcTangent, an_edge_subtends_the_same_angle_by_series_and_by_root) {
    for (double angle = 3.1; angle > 1e-9; angle *= 0.97) {
        const double length = 0.3;  // of both vectors
        const double across = length * length * std::sin(angle), dot = length * length * std::cos(angle);
        EXPECT_NEAR(angle_over_cross(across * across, dot) * across / angle, 1.0, 1e-15) << angle;
    }
}

TEST(ArcTangent, the_axes_are_quarter_turns) {
    EXPECT_EQ(arc_tangent(0.0, 0.0), 0.0);
    EXPECT_EQ(arc_tangent(0.0, 2.0), 0.0);
    EXPECT_EQ(arc_tangent(2.0, 0.0), 0.5 * std::numbers::pi);
    EXPECT_EQ(arc_tangent(-2.0, 0.0), -0.5 * std::numbers::pi);
    EXPECT_EQ(arc_tangent(0.0, -2.0), std::numbers::pi);
}

}  // namespace
}  // namespace hanei
