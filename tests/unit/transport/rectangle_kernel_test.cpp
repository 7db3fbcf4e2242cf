#include "engine/transport/rectangle_kernel.h"

#include <cmath>
#include <gtest/gtest.h>

namespace hanei {
namespace {

const Polygon rectangle = {{0, 0, 0}, {0.6, 0, 0}, {0.6, 0.4, 0}, {0, 0.4, 0}};
const PatchFrame frame = frame_of(rectangle, {0, 0, 1}, {1, 0, 0});

std::vector<Receiver> receivers_above_all() {
    std::vector<Receiver> receivers;
    for (const double height : {1e-6, 1e-3, 0.05, 0.4, 1.5}) {
        for (const Vec2& foot : {Vec2{0.3, 0.2}, Vec2{0.0, 0.0}, Vec2{-0.1, 0.15}, Vec2{0.61, -0.9}}) {
            receivers.push_back({{foot, height}, {0, 0, -1}, Vec3{0.0}});
        }
        receivers.push_back({{-0.1, 0.15, height}, {1, 0, 0}, Vec3{0.0}});
        receivers.push_back({{0.2, -0.05, height}, {0, 1, 0}, Vec3{0.0}});
        receivers.push_back({{-0.3, -0.05, height}, glm::normalize(Vec3{1, 0.2, 0}), Vec3{0.0}});
        receivers.push_back({{-0.1, -0.2, height}, glm::normalize(Vec3{0.3, 0.8, -0.5}), Vec3{0.0}});
    }
    return receivers;
}

TEST(RectangleKernel, has_the_factor_of_the_contour) {
    for (const Receiver& receiver : receivers_above_all()) {
        const double expected = configuration_factor(rectangle, receiver);
        // above a corner the rounding of a coordinate counts by its share of the height
        const double rounding = 1e-16 / receiver.position.z;
        EXPECT_NEAR(rectangle_factor(frame, receiver), expected, 1e-12 * expected + rounding);
        EXPECT_EQ(rectangle_middle(frame, receiver).factor, rectangle_factor(frame, receiver));
    }
}

TEST(RectangleKernel, has_the_middle_of_the_sum_over_its_edges) {
    for (const Receiver& receiver : receivers_above_all()) {
        if (receiver.position.z < 1e-4) continue;  // of a factor of 1e-12 the sums keep few digits
        const KernelMiddle expected = kernel_middle(rectangle, frame, receiver);
        const KernelMiddle seen = rectangle_middle(frame, receiver);
        // Gauss's rule along different lines
        EXPECT_NEAR(seen.middle.x, expected.middle.x, 1e-5);
        EXPECT_NEAR(seen.middle.y, expected.middle.y, 1e-5);
        EXPECT_NEAR(seen.product, expected.product, 1e-5);
    }
}

TEST(RectangleKernel, light_from_a_touching_rectangle_comes_from_the_foot) {
    const Receiver above{{0.1, 0.3, 1e-8}, {0, 0, -1}, Vec3{0.0}};
    const KernelMiddle seen = rectangle_middle(frame, above);
    const Vec2 foot = frame.coordinates({0.1, 0.3, 0.0});
    EXPECT_NEAR(seen.factor, 1.0, 1e-12);
    EXPECT_NEAR(seen.middle.x, foot.x, 1e-6);
    EXPECT_NEAR(seen.middle.y, foot.y, 1e-6);
    EXPECT_NEAR(seen.product, foot.x * foot.y, 1e-6);
}

}  // namespace
}  // namespace hanei
