#include "engine/geometry/edge_sums.h"

#include "tests/quad_precision.h"
#include "tests/unit/geometry/shapes.h"

#include <cmath>
#include <gtest/gtest.h>
#include <numbers>

namespace hanei {
namespace {

using testing::Dice;

/// A star of 3 to 20 corners above the horizon of `normal`, its size at most `size` of its distance.
struct Star {
    std::vector<Vec3> offsets;
    Vec3 first, middle, normal;

    Star(Dice& dice, double size) {
        const Mat3 turn = dice.rotation();
        const Vec3 towards = dice.direction();
        normal = glm::normalize(towards + 0.3 * dice.direction());
        const int corners = 3 + static_cast<int>(dice.uniform(0, 18));
        for (int k = 0; k < corners; ++k) {
            const double angle = 2 * std::numbers::pi * k / corners, reach = 0.5 * size * dice.uniform(0.5, 1);
            offsets.push_back(turn * (reach * Vec3{std::cos(angle), std::sin(angle), 0}));
        }
        const Vec3 start = offsets[0];
        middle = Vec3{0};
        for (Vec3& offset : offsets) middle += (offset -= start) / static_cast<double>(corners);
        first = towards + start;
    }
    SeenLoop loop() const { return {first, offsets}; }
    double far(Registers registers) const { return far_sum(loop(), middle, first + middle, normal, registers); }

    /// Also of what faces away, as the sums are for holes.
    double exact() const {
        std::vector<testing::QuadVec> seen, mirrored;
        for (const Vec3& offset : offsets) seen.push_back(testing::QuadVec(first) + testing::QuadVec(offset));
        mirrored.assign(seen.rbegin(), seen.rend());
        const testing::QuadVec up(normal);
        return static_cast<double>(testing::quad_factor(seen, up) - testing::quad_factor(mirrored, up));
    }
};

TEST(EdgeSums, the_same_bits_by_registers_of_two_numbers_and_of_four) {
    if (registers_here() == Registers::two) GTEST_SKIP() << "this machine has registers of two numbers alone";
    Dice dice(17);
    for (int k = 0; k < 5000; ++k) {
        const Star star(dice, std::pow(10.0, dice.uniform(-6, 0)));
        ASSERT_EQ(near_sum(star.loop(), star.normal, Registers::two),
                  near_sum(star.loop(), star.normal, Registers::four));
        ASSERT_EQ(star.far(Registers::two), star.far(Registers::four));
    }
}

TEST(EdgeSums, of_near_loops_hold_a_rounding_of_one) {
    Dice dice(18);
    for (int k = 0; k < 5000; ++k) {
        const Star star(dice, dice.uniform(0.1, 1));
        ASSERT_NEAR(near_sum(star.loop(), star.normal), star.exact(), 4e-16) << k;
    }
}

TEST(EdgeSums, of_far_loops_hold_a_rounding_of_themselves) {
    Dice dice(19);
    for (int k = 0; k < 5000; ++k) {
        const double size = std::pow(10.0, dice.uniform(-7, 0));
        const Star star(dice, size);
        const double head_on = size * size / 4;  // and more: of the disc around it, seen from its front
        ASSERT_NEAR(star.far(registers_here()), star.exact(), 1e-15 * head_on) << k;
    }
}

}  // namespace
}  // namespace hanei
