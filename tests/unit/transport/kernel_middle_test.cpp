#include "engine/transport/kernel_middle.h"

#include <cmath>
#include <gtest/gtest.h>
#include <numbers>

namespace hanei {
namespace {

const Vec3 up{0.0, 0.0, 1.0};
const Polygon square = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
const Polygon triangle = {{0, 0, 0}, {0.6, 0.1, 0}, {0.1, 0.4, 0}};
const Polygon wedge = {{0, 0, 0}, {0.8, 0, 0}, {0.9, 0.1, 0}, {0.4, 0.5, 0}, {-0.1, 0.3, 0}};

/// The integrals on a fine grid of each triangle of the fan.
KernelMiddle by_force(const Polygon& polygon, const PatchFrame& frame, const Receiver& receiver) {
    constexpr int steps = 300;
    KernelMiddle sum;
    const auto add = [&](const Vec3& place, double area) {
        const Vec3 seen = place - receiver.position;
        const double square_of = glm::dot(seen, seen);
        const double light = area * std::max(0.0, glm::dot(seen, receiver.normal)) * std::max(0.0, -seen.z) /
                             (std::numbers::pi * square_of * square_of);
        const Vec2 at = frame.coordinates(place);
        sum.factor += light;
        sum.middle += light * at;
        sum.product += light * at.x * at.y;
    };
    for (std::size_t k = 2; k < polygon.size(); ++k) {
        const Vec3 a = (polygon[k - 1] - polygon[0]) / double{steps}, b = (polygon[k] - polygon[0]) / double{steps};
        const double area = 0.5 * glm::length(glm::cross(a, b));
        for (int i = 0; i < steps; ++i) {
            for (int j = 0; i + j < steps; ++j) {
                const Vec3 corner = polygon[0] + double(i) * a + double(j) * b;
                add(corner + (a + b) / 3.0, area);
                if (i + j + 1 < steps) add(corner + 2.0 * (a + b) / 3.0, area);
            }
        }
    }
    sum.middle /= sum.factor;
    sum.product /= sum.factor;
    return sum;
}

TEST(KernelMiddle, of_any_convex_polygon_nearby_is_what_a_fine_grid_gives) {
    for (const Polygon& polygon : {square, triangle, wedge}) {
        const PatchFrame frame = frame_of(polygon, up, {1, 0, 0});
        for (const double height : {0.03, 0.2, 0.7}) {
            for (const Receiver& receiver :
                 {Receiver{{0.2, 0.15, height}, {0, 0, -1}, Vec3{0.0}},
                  Receiver{{-0.15, 0.1, height}, {1, 0, 0}, Vec3{0.0}},
                  Receiver{{-0.2, -0.05, height}, glm::normalize(Vec3{2, 1, 0}), Vec3{0.0}},
                  Receiver{{0.2, -0.5, height}, glm::normalize(Vec3{-0.2, 0.8, -0.5}), Vec3{0.0}}}) {
                const KernelMiddle expected = by_force(polygon, frame, receiver);
                const KernelMiddle seen = kernel_middle(polygon, frame, receiver);
                // the grid is 1/300 of the side, a tenth of the least height; Gauss's rule leaves out 1e-5
                EXPECT_NEAR(seen.factor, expected.factor, 2e-3 * expected.factor);
                EXPECT_NEAR(seen.middle.x, expected.middle.x, 2e-3);
                EXPECT_NEAR(seen.middle.y, expected.middle.y, 2e-3);
                EXPECT_NEAR(seen.product, expected.product, 3e-3);
            }
        }
    }
}

TEST(KernelMiddle, of_what_the_horizon_leaves_is_in_what_it_leaves) {
    const PatchFrame frame = frame_of(square, up, {1, 0, 0});
    const Receiver receiver{{0.6, 0.3, 0.4}, {1, 0, 0}, Vec3{0.0}};
    const KernelMiddle expected = by_force(square, frame, receiver);
    const KernelMiddle seen = kernel_middle(square, frame, receiver);
    EXPECT_NEAR(seen.middle.x, expected.middle.x, 1e-3);
    EXPECT_NEAR(seen.middle.y, expected.middle.y, 1e-3);
    EXPECT_NEAR(seen.product, expected.product, 1e-3);
}

TEST(KernelMiddle, near_and_far_ways_agree_where_they_meet) {
    for (const Polygon& polygon : {square, triangle, wedge}) {
        const PatchFrame frame = frame_of(polygon, up, {1, 0, 0});
        const auto from = [&](double distance) {
            const Vec3 normal = glm::normalize(Vec3{0.3, 0.2, -1.0});
            return kernel_middle(polygon, frame, {frame.centre - distance * normal, normal, Vec3{0.0}});
        };
        double reach = 0.0;
        for (const Vec3& corner : polygon) reach = std::max(reach, glm::length(corner - frame.centre));
        const KernelMiddle near = from(reach / 0.07 * (1.0 - 1e-9)), far = from(reach / 0.07 * (1.0 + 1e-9));
        EXPECT_LT(glm::length(near.middle - far.middle), 1e-2);
        EXPECT_NEAR(near.product, far.product, 1e-2);
    }
}

TEST(KernelMiddle, of_a_patch_far_away_is_its_centre_and_of_one_touched_the_place_of_touch) {
    const PatchFrame frame = frame_of(square, up, {1, 0, 0});
    const KernelMiddle far = kernel_middle(square, frame, {{0.5, 0.5, 100.0}, {0, 0, -1}, Vec3{0.0}});
    EXPECT_LT(glm::length(far.middle), 1e-9);
    // a wall's foot at (0.3, 0): half of what it sees is the floor, all of that within no distance
    const KernelMiddle touching = kernel_middle(square, frame, {{0.3, 0.0, 0.0}, {0, 1, 0}, {0, 0, 1}});
    EXPECT_NEAR(touching.factor, 0.5, 1e-12);
    EXPECT_NEAR(touching.middle.x, -0.2 * std::sqrt(12.0), 1e-12);
    EXPECT_NEAR(touching.middle.y, -0.5 * std::sqrt(12.0), 1e-12);
    EXPECT_EQ(kernel_middle(square, frame, {{0.5, 0.5, -1.0}, {0, 0, 1}, Vec3{0.0}}).factor, 0.0);
}

TEST(NodeShares, add_up_to_the_factor_and_are_never_below_0_wherever_the_middle_is) {
    for (double x = -1.7; x < 1.8; x += 0.2) {
        for (double y = -1.7; y < 1.8; y += 0.2) {
            for (double product = -3.0; product < 3.1; product += 0.5) {
                double sum = 0.0;
                for (const double share : node_shares({0.3, {x, y}, product})) {
                    EXPECT_GE(share, 0.0);
                    sum += share;
                }
                EXPECT_NEAR(sum, 0.3, 1e-15);
            }
        }
    }
}

}  // namespace
}  // namespace hanei
