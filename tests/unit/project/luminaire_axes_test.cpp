#include "engine/project/luminaire_axes.h"

#include "engine/scene/placement.h"

#include <cmath>
#include <gtest/gtest.h>
#include <random>

namespace hanei {
namespace {

constexpr double rounding = 1e-15;  // three turns of unit vectors, each a few parts in 1e16

void expect_aimed(const Vec3& nadir, const Vec3& c0) {
    Luminaire luminaire;
    aim(luminaire, nadir, c0);
    const Placement placed = placement(luminaire);
    EXPECT_LE(glm::distance(placed.direction({0, 0, -1}), nadir), 4.0 * rounding)
        << nadir.x << ' ' << nadir.y << ' ' << nadir.z;
    EXPECT_LE(glm::distance(placed.direction({1, 0, 0}), c0), 4.0 * rounding);
}

TEST(LuminaireAxes, a_luminaire_that_hangs_straight_has_all_angles_zero) {
    Luminaire luminaire;
    aim(luminaire, {0, 0, -1}, {1, 0, 0});
    EXPECT_EQ(luminaire.yaw, 0.0);
    EXPECT_EQ(luminaire.tilt, 0.0);
    EXPECT_EQ(luminaire.roll, 0.0);
    EXPECT_EQ(placement(luminaire).rotation, Mat3(1.0));
}

TEST(LuminaireAxes, the_placement_of_the_angles_found_has_the_axes_asked_for) {
    std::mt19937_64 random(3);
    std::normal_distribution<double> normal;
    for (int i = 0; i < 1000; ++i) {
        const Vec3 nadir = glm::normalize(Vec3{normal(random), normal(random), normal(random)});
        const Vec3 any = glm::normalize(Vec3{normal(random), normal(random), normal(random)});
        expect_aimed(nadir, glm::normalize(glm::cross(nadir, any)));
    }
}

TEST(LuminaireAxes, axes_along_the_rooms_axes_are_met_in_all_24_ways) {
    const Vec3 axes[] = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
    for (const Vec3& nadir : axes)
        for (const Vec3& c0 : axes)
            if (glm::dot(nadir, c0) == 0.0) expect_aimed(nadir, c0);
}

TEST(LuminaireAxes, a_plane_0_can_be_found_for_every_nadir) {
    for (const Vec3& nadir : {Vec3{1, 0, 0}, Vec3{0, -1, 0}, Vec3{0, 0, -1}, Vec3{0.95, 0.1, 0.2}}) {
        EXPECT_NEAR(glm::dot(any_c0(nadir), nadir), 0.0, rounding);
        EXPECT_NEAR(glm::length(any_c0(nadir)), 1.0, rounding);
    }
    EXPECT_EQ(any_c0({0, 0, -1}), Vec3(1, 0, 0));
}

}  // namespace
}  // namespace hanei
