#include "engine/scene/placement.h"

#include <gtest/gtest.h>
#include <numbers>

namespace hanei {
namespace {

constexpr double quarter = std::numbers::pi / 2.0;

Vec3 aimed(double yaw, double tilt, double roll) {
    Luminaire luminaire;
    luminaire.yaw = yaw;
    luminaire.tilt = tilt;
    luminaire.roll = roll;
    return placement(luminaire).direction({0.0, 0.0, -1.0});
}

TEST(Placement, an_unturned_luminaire_has_exactly_the_identity) {
    EXPECT_EQ(placement(Luminaire{}).rotation, Mat3{1.0});
    EXPECT_EQ(placement(Furniture{}).rotation, Mat3{1.0});
}

TEST(Placement, tilt_turns_the_nadir_towards_plane_0) { EXPECT_EQ(aimed(0.0, quarter, 0.0), Vec3(1.0, 0.0, 0.0)); }

TEST(Placement, yaw_turns_a_tilted_luminaire_counter_clockwise_seen_from_above) {
    EXPECT_EQ(aimed(quarter, quarter, 0.0), Vec3(0.0, 1.0, 0.0));
}

TEST(Placement, roll_turns_the_nadir_about_the_luminaires_own_x_axis) {
    EXPECT_EQ(aimed(0.0, 0.0, quarter), Vec3(0.0, 1.0, 0.0));
    EXPECT_EQ(aimed(0.0, quarter, quarter), Vec3(0.0, 1.0, 0.0));  // x points up then: the nadir still swings to y
}

TEST(Placement, four_quarter_turns_end_where_they_began) {
    Furniture furniture;
    furniture.rotation = 4.0 * quarter;
    EXPECT_EQ(placement(furniture).rotation, Mat3{1.0});
}

TEST(Placement, a_part_is_placed_in_its_furniture_and_the_furniture_in_the_room) {
    Furniture desk;
    desk.position = {2.0, 3.0, 0.5};
    desk.rotation = quarter;
    Part drawer;
    drawer.position = {1.0, 0.0, 0.25};
    drawer.rotation = quarter;
    const Placement placed = placement(desk, drawer);
    EXPECT_EQ(placed.position, Vec3(2.0, 4.0, 0.75));
    EXPECT_EQ(placed.direction({1.0, 0.0, 0.0}), Vec3(-1.0, 0.0, 0.0));
}

TEST(Placement, a_region_keeps_its_holes) {
    Furniture furniture;
    furniture.position = {1.0, 0.0, 0.0};
    const Region local{{{0, 0, 0}, {3, 0, 0}, {3, 3, 0}, {0, 3, 0}}, {{{1, 1, 0}, {1, 2, 0}, {2, 2, 0}, {2, 1, 0}}}};
    const Region placed = placement(furniture).region(local);
    EXPECT_EQ(placed.outline[1], Vec3(4.0, 0.0, 0.0));
    EXPECT_EQ(placed.holes[0][2], Vec3(3.0, 2.0, 0.0));
}

}  // namespace
}  // namespace hanei
