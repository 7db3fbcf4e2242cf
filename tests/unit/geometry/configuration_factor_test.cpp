#include "engine/geometry/configuration_factor.h"

#include "tests/unit/geometry/shapes.h"

#include <cmath>
#include <gtest/gtest.h>
#include <numbers>

namespace hanei {
namespace {

using std::numbers::pi;
using testing::Dice;
using testing::facing_down;
using testing::facing_up;

/// Rectangle a x b parallel to the receiver at distance c, one corner straight over it (any
/// handbook of configuration factors).
double corner_over(double a, double b, double c) {
    const double x = a / c, y = b / c;
    return (x / std::sqrt(1 + x * x) * std::atan(y / std::sqrt(1 + x * x)) +
            y / std::sqrt(1 + y * y) * std::atan(x / std::sqrt(1 + y * y))) /
           (2 * pi);
}

/// Rectangle of height a and width b standing upright at distance c, its lower corner in front.
double corner_upright(double a, double b, double c) {
    const double x = a / b, y = c / b;
    return (std::atan(1 / y) - y / std::hypot(x, y) * std::atan(1 / std::hypot(x, y))) / (2 * pi);
}

const Receiver upward{};

TEST(ConfigurationFactor, a_rectangle_overhead_has_its_closed_form) {
    for (const double distance : {0.01, 0.3, 1.0, 2.5, 15.0}) {
        const double expected = corner_over(1.2, 0.6, distance);
        const double got = configuration_factor(facing_down(0, 0, 1.2, 0.6, distance), upward);
        EXPECT_NEAR(got, expected, 1e-14) << distance;  // a few roundings of the sum
    }
}

TEST(ConfigurationFactor, an_upright_rectangle_has_its_closed_form) {
    const Polygon wall = {{0, 0.7, 0}, {2, 0.7, 0}, {2, 0.7, 1.5}, {0, 0.7, 1.5}};  // faces -y
    EXPECT_NEAR(configuration_factor(wall, upward), corner_upright(1.5, 2, 0.7), 1e-15);
}

TEST(ConfigurationFactor, a_fine_polygon_approaches_the_disc) {
    Polygon disc;
    const int corners = 4000;
    for (int k = 0; k < corners; ++k) {
        const double angle = -2 * pi * k / corners;
        disc.emplace_back(0.5 * std::cos(angle), 0.5 * std::sin(angle), 1.0);
    }
    // The inscribed polygon misses (2 pi / n)^2 / 6 = 4e-7 of the disc's area.
    EXPECT_NEAR(configuration_factor(disc, upward), 0.25 / 1.25, 2e-7);
}

TEST(ConfigurationFactor, only_the_front_shines) {
    EXPECT_EQ(configuration_factor(facing_up(-1, -1, 1, 1, 1), upward), 0.0);
    EXPECT_EQ(configuration_factor(facing_down(-1, -1, 1, 1, -1), upward), 0.0);
    EXPECT_EQ(configuration_factor(facing_down(-1, -1, 1, 1, 0), {{0, 0, 0}, {0, 0, -1}, {}}), 0.0);
}

TEST(ConfigurationFactor, an_opening_half_below_the_horizon_gives_half_the_light_of_its_mirror_pair) {
    const Polygon whole = {{-1, 2, -1.5}, {1, 2, -1.5}, {1, 2, 1.5}, {-1, 2, 1.5}};
    const Polygon upper = {{-1, 2, 0}, {1, 2, 0}, {1, 2, 1.5}, {-1, 2, 1.5}};
    EXPECT_NEAR(configuration_factor(whole, upward), configuration_factor(upper, upward), 1e-16);
}

TEST(ConfigurationFactor, a_point_in_the_opening_that_it_faces_sees_nothing_else) {
    EXPECT_NEAR(configuration_factor(facing_down(-1, -1, 1, 1, 0), upward), 1.0, 1e-15);
    EXPECT_NEAR(configuration_factor(facing_down(0.5, -1, 1, 1, 0), upward), 0.0, 1e-16);
    EXPECT_EQ(configuration_factor(facing_up(-1, -1, 1, 1, 0), upward), 0.0);
    const Vec3 tilted = glm::normalize(Vec3{1, 0, 1});
    EXPECT_NEAR(configuration_factor(facing_down(-1, -1, 1, 1, 0), {{0, 0, 0}, tilted, {}}), 0.5 * (1 + tilted.z),
                1e-15);
}

TEST(ConfigurationFactor, the_foot_of_a_wall_sees_it_fill_half_its_view) {
    const Polygon wall = {{-1, 0, 0}, {1, 0, 0}, {1, 0, 2}, {-1, 0, 2}};  // faces -y
    EXPECT_NEAR(configuration_factor(wall, {{0.3, 0, 0}, {0, 0, 1}, {0, -1, 0}}), 0.5, 1e-15);
    EXPECT_NEAR(configuration_factor(wall, {{0.3, 0, 0}, {0, 0, 1}, {}}), 0.5, 1e-15);
    EXPECT_EQ(configuration_factor(wall, {{0.3, 0, 0}, {0, 0, 1}, {0, 1, 0}}), 0.0);
    EXPECT_NEAR(configuration_factor(wall, {{3, 0, 0}, {0, 0, 1}, {0, -1, 0}}), 0.0, 1e-15);
}

TEST(ConfigurationFactor, a_corner_is_the_limit_from_inside_the_face) {
    const Polygon wall = {{0, 0, 0}, {5, 0, 0}, {5, 0, 3}, {0, 0, 3}};  // faces -y
    const Vec3 inward = glm::normalize(Vec3{1, -1, 0});
    const double limit = configuration_factor(wall, {{0, 0, 0}, {0, 0, 1}, inward});
    EXPECT_NEAR(limit, 0.375, 1e-15);
    const double near = configuration_factor(wall, {1e-7 * inward, {0, 0, 1}, {}});
    EXPECT_NEAR(near, limit, 1e-6);  // the way to go is 1e-7 of the wall
}

TEST(ConfigurationFactor, a_point_amid_an_upright_edge_is_the_limit_from_inside_the_face) {
    for (int k = 1; k < 200; ++k) {
        // The wall's slanted edge passes through the point from below its horizon to above it.
        const double below = 0.01 * k, slant = 0.3 + 0.002 * k, turn = 0.1 * k;
        const Vec3 side{std::cos(turn), std::sin(turn), 0}, inward{-side.y, side.x, 0},
            edge = slant * side + Vec3{0, 0, 1};
        const Polygon wall{-below * edge, edge, edge + side, -below * edge + side};
        const double limit = configuration_factor(wall, {{0, 0, 0}, {0, 0, 1}, inward});
        const double near = configuration_factor(wall, {1e-7 * inward, {0, 0, 1}, {}});
        EXPECT_GT(limit, 0.01) << k;
        EXPECT_NEAR(limit, near, 1e-6) << k;  // 1e-7 m beside the edge of a metre-sized wall
    }
}

TEST(ConfigurationFactor, six_faces_of_a_room_close_around_every_kind_of_receiver) {
    const auto closure = [](const Receiver& receiver) {
        const double x = 5, y = 4, z = 3;
        const Polygon faces[] = {facing_up(0, 0, x, y, 0),
                                 facing_down(0, 0, x, y, z),
                                 {{0, 0, 0}, {0, 0, z}, {x, 0, z}, {x, 0, 0}},
                                 {{0, y, 0}, {x, y, 0}, {x, y, z}, {0, y, z}},
                                 {{0, 0, 0}, {0, y, 0}, {0, y, z}, {0, 0, z}},
                                 {{x, 0, 0}, {x, 0, z}, {x, y, z}, {x, y, 0}}};
        double sum = 0;
        for (const Polygon& face : faces) sum += configuration_factor(face, receiver);
        return sum;
    };
    EXPECT_NEAR(closure({{1, 2, 1}, glm::normalize(Vec3{1, 2, 3}), {}}), 1, 1e-14);
    EXPECT_NEAR(closure({{1, 2, 0}, {0, 0, 1}, {}}), 1, 1e-14);
    EXPECT_NEAR(closure({{0, 2, 0}, {0, 0, 1}, {1, 0, 0}}), 1, 1e-14);
    EXPECT_NEAR(closure({{0, 0, 0}, {0, 0, 1}, glm::normalize(Vec3{2, 1, 0})}), 1, 1e-14);
}

TEST(ConfigurationFactor, holes_and_concave_outlines_take_away_what_they_cover) {
    const Region framed{facing_down(-2, -2, 2, 2, 1.3), {facing_up(-1, -1, 1, 0.5, 1.3)}};
    const double whole = configuration_factor(facing_down(-2, -2, 2, 2, 1.3), upward);
    const double hole = configuration_factor(facing_down(-1, -1, 1, 0.5, 1.3), upward);
    EXPECT_NEAR(configuration_factor(framed, upward), whole - hole, 1e-15);

    const Polygon corner = {{0, 0, 1}, {0, 2, 1}, {1, 2, 1}, {1, 1, 1}, {2, 1, 1}, {2, 0, 1}};
    const double parts = configuration_factor(facing_down(0, 0, 1, 2, 1), upward) +
                         configuration_factor(facing_down(1, 0, 2, 1, 1), upward);
    EXPECT_NEAR(configuration_factor(corner, upward), parts, 1e-15);
}

TEST(ConfigurationFactor, a_concave_outline_across_the_horizon_equals_its_parts) {
    const Receiver leaning{{0, 0, 0}, glm::normalize(Vec3{1, 0.2, 0.1}), {}};
    const Polygon u_shape = {{-2, -2, 1}, {-2, 2, 1},  {2, 2, 1},  {2, 1, 1},
                             {-1, 1, 1},  {-1, -1, 1}, {2, -1, 1}, {2, -2, 1}};
    const double parts = configuration_factor(facing_down(-2, -2, -1, 2, 1), leaning) +
                         configuration_factor(facing_down(-1, 1, 2, 2, 1), leaning) +
                         configuration_factor(facing_down(-1, -2, 2, -1, 1), leaning);
    EXPECT_NEAR(configuration_factor(u_shape, leaning), parts, 1e-15);
}

TEST(ConfigurationFactor, a_tiny_far_opening_keeps_all_its_digits) {
    for (const double size : {1e-1, 1e-2, 1e-3, 1e-5, 1e-7}) {
        const double h = 0.5 * size;
        const Polygon opening = facing_down(0.7 - h, 0.2 - h, 0.7 + h, 0.2 + h, 1.1);
        const double got = configuration_factor(opening, upward);
        const double expected = corner_over(0.7 + h, 0.2 + h, 1.1) - corner_over(0.7 - h, 0.2 + h, 1.1) -
                                corner_over(0.7 + h, 0.2 - h, 1.1) + corner_over(0.7 - h, 0.2 - h, 1.1);
        const double cancelled = 2e-15 / (size * size);  // of the differences
        EXPECT_NEAR(got / expected, 1, cancelled) << size;
        const double r2 = 0.7 * 0.7 + 0.2 * 0.2 + 1.1 * 1.1;
        const double point_like = size * size * 1.1 * 1.1 / (pi * r2 * r2);
        EXPECT_NEAR(got / point_like, 1, 0.5 * size * size + 2e-9 * (size < 1e-4) + 1e-15) << size;
    }
}

TEST(ConfigurationFactor, the_sums_for_near_and_far_openings_meet) {
    // Sizes at which the rule changes for the whole or for its quarters, against the opening cut in four.
    for (const double size : {0.01, 0.3, 0.95, 0.99, 1.0, 1.05, 1.9, 2.0, 2.1}) {
        const double h = 0.5 * size / std::sqrt(2.0);
        const Vec3 normal = glm::normalize(Vec3{0.3, -0.2, 1});
        const Receiver receiver{{-0.4, 0.1, 0}, normal, {}};
        const double d = 0.9;
        const double whole = configuration_factor(facing_down(-h, -h, h, h, d), receiver);
        const double parts = configuration_factor(facing_down(-h, -h, 0, 0, d), receiver) +
                             configuration_factor(facing_down(0, -h, h, 0, d), receiver) +
                             configuration_factor(facing_down(-h, 0, 0, h, d), receiver) +
                             configuration_factor(facing_down(0, 0, h, h, d), receiver);
        EXPECT_NEAR(whole / parts, 1, 2e-15) << size;  // a few roundings on either side
    }
}

/// A polygon as unkind as rounding can make it.
Polygon hostile(Dice& dice) {
    const double size = std::pow(10.0, dice.uniform(-7, 3));
    const double squeeze = std::pow(10.0, dice.uniform(-7, 0));
    const Mat3 turn = dice.rotation();
    const Vec3 shift = dice.uniform(0, 1) < 0.3 ? Vec3{0} : dice.place(2);
    Polygon polygon;
    const int corners = 3 + static_cast<int>(dice.uniform(0, 4));
    for (int k = 0; k < corners; ++k) {
        const double angle = 2 * pi * k / corners + dice.uniform(0, 0.5);
        polygon.push_back(shift + turn * (size * Vec3{std::cos(angle), squeeze * std::sin(angle), 0}));
        if (dice.uniform(0, 1) < 0.1) polygon.push_back(polygon.back() + dice.place(1e-9 * size));
        if (dice.uniform(0, 1) < 0.05) polygon.push_back(polygon.back());
    }
    if (dice.uniform(0, 1) < 0.2) {  // put the receiver onto an edge, a corner or into the plane
        const Vec3 onto = dice.uniform(0, 1) < 0.5 ? polygon[0] : 0.5 * (polygon[0] + polygon[1]);
        for (Vec3& corner : polygon) corner -= onto;
    }
    return polygon;
}

TEST(ConfigurationFactor, a_hundred_thousand_hostile_polygons_stay_between_0_and_1) {
    Dice dice(7);
    for (int k = 0; k < 100'000; ++k) {
        const Polygon polygon = hostile(dice);
        const Vec3 normal = dice.direction();
        Vec3 inward = glm::normalize(glm::cross(normal, dice.direction()));
        if (dice.uniform(0, 1) < 0.5) inward = Vec3{0};
        const double got = configuration_factor(polygon, {{0, 0, 0}, normal, inward});
        ASSERT_TRUE(got >= 0 && got <= 1) << k << " gives " << got;
    }
}

TEST(ConfigurationFactor, moved_turned_and_scaled_rooms_give_the_same) {
    Dice dice(11);
    for (int k = 0; k < 2000; ++k) {
        const Mat3 turn = dice.rotation();
        const Vec3 shift = dice.place(1e5);
        const double scale = std::pow(10.0, dice.uniform(-3, 3));
        Polygon polygon = facing_down(-0.4, -0.3, 0.8, 0.7, 0);
        const Mat3 tilt = dice.rotation();
        const Vec3 away = 2.0 * dice.direction();
        Polygon moved, scaled;
        for (Vec3& corner : polygon) corner = tilt * corner + away;
        for (const Vec3& corner : polygon) moved.push_back(turn * corner + shift);
        for (const Vec3& corner : polygon) scaled.push_back(scale * corner);
        const Receiver receiver{{0.1, 0.2, 0.3}, dice.direction(), {}};
        const double here = configuration_factor(polygon, receiver);
        const double there =
            configuration_factor(moved, {turn * receiver.position + shift, turn * receiver.normal, {}});
        // 1.5e-11 m of rounding at 1e5 m, metre-sized room
        EXPECT_NEAR(there, here, 1e-10);
        EXPECT_NEAR(configuration_factor(scaled, {scale * receiver.position, receiver.normal, {}}), here, 1e-14);
    }
}

TEST(ConfigurationFactor, without_area_there_is_no_light) {
    EXPECT_EQ(configuration_factor(Polygon{}, upward), 0.0);
    EXPECT_EQ(configuration_factor(Polygon{{0, 0, 1}, {1, 0, 1}}, upward), 0.0);
    EXPECT_EQ(configuration_factor(Polygon{{0, 0, 1}, {1, 0, 1}, {2, 0, 1}}, upward), 0.0);
    EXPECT_EQ(configuration_factor(Polygon{{1, 0, 1}, {1, 0, 1}, {1, 0, 1}}, upward), 0.0);
}

}  // namespace
}  // namespace hanei
