#include "engine/transport/factors.h"
#include "tests/unit/mesh/sample_scenes.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <numbers>

namespace hanei {
namespace {

constexpr double pi = std::numbers::pi;
const OccluderSet nothing;

/// Aligned rectangles a x b at the distance c (closed form: Hottel, in any heat transfer handbook).
double between_parallel(double a, double b, double c) {
    const double x = a / c, y = b / c;
    const double u = std::sqrt(1.0 + x * x), v = std::sqrt(1.0 + y * y);
    return 2.0 / (pi * x * y) *
           (std::log(u * v / std::sqrt(1.0 + x * x + y * y)) + x * v * std::atan(x / v) + y * u * std::atan(y / u) -
            x * std::atan(x) - y * std::atan(y));
}

/// Perpendicular rectangles with a common edge l: from one w wide to one h high.
double between_hinged(double l, double w, double h) {
    const double x = h / l, y = w / l;
    const double x2 = x * x, y2 = y * y, z2 = x2 + y2;
    const double logs = std::log((1.0 + x2) * (1.0 + y2) / (1.0 + z2)) +
                        y2 * std::log(y2 * (1.0 + z2) / ((1.0 + y2) * z2)) +
                        x2 * std::log(x2 * (1.0 + z2) / ((1.0 + x2) * z2));
    return (y * std::atan(1.0 / y) + x * std::atan(1.0 / x) - std::sqrt(z2) * std::atan(1.0 / std::sqrt(z2)) +
            0.25 * logs) /
           (pi * y);
}

Region level(double x0, double y0, double x1, double y1, double z, bool up) {
    Polygon outline{{x0, y0, z}, {x1, y0, z}, {x1, y1, z}, {x0, y1, z}};
    if (!up) std::reverse(outline.begin(), outline.end());
    return {std::move(outline), {}};
}

Region upright(double l, double h) { return {{{0, 0, 0}, {0, l, 0}, {0, l, h}, {0, 0, h}}, {}}; }

TEST(FormFactor, parallel_rectangles_meet_the_closed_form) {
    for (const auto& [a, b, c] : {std::tuple(1.0, 1.0, 1.0), std::tuple(2.0, 1.0, 0.01), std::tuple(1.0, 3.0, 5.0)}) {
        const double got = form_factor(level(0, 0, a, b, 0.0, true), level(0, 0, a, b, c, false), nothing);
        EXPECT_NEAR(got, between_parallel(a, b, c), 1e-11);  // the closed form itself cancels at small c
    }
    const double far = form_factor(level(0, 0, 1, 1, 0.0, true), level(0, 0, 1, 1, 50.0, false), nothing);
    EXPECT_NEAR(far / (1.0 / (pi * 2500.0)), 1.0, 1e-3);  // the inverse square, to the square of size over distance
}

TEST(FormFactor, hinged_plates_meet_the_closed_form) {
    for (const auto& [l, w, h] : {std::tuple(1.0, 1.0, 1.0), std::tuple(2.0, 4.0, 3.0), std::tuple(1.0, 1.0, 0.001)}) {
        const double got = form_factor(level(0, 0, w, l, 0.0, true), upright(l, h), nothing);
        EXPECT_NEAR(got, between_hinged(l, w, h), 1e-12);
    }
}

TEST(FormFactor, is_0_from_behind_and_counts_only_what_is_above_the_horizon) {
    EXPECT_EQ(form_factor(level(0, 0, 1, 1, 0.0, false), level(0, 0, 1, 1, 1.0, false), nothing), 0.0);
    EXPECT_EQ(form_factor(level(0, 0, 1, 1, 0.0, true), level(0, 0, 1, 1, 0.0, false), nothing), 0.0);
    const Region whole{{{0, 0, -1}, {0, 1, -1}, {0, 1, 1}, {0, 0, 1}}, {}};
    EXPECT_NEAR(form_factor(level(0, 0, 1, 1, 0.0, true), whole, nothing), between_hinged(1, 1, 1), 1e-12);
}

TEST(FormFactor, a_hole_takes_away_what_it_would_have_given) {
    const Region floor = level(0, 0, 2, 2, 0.0, true);
    Region plate = level(0, 0, 2, 2, 1.0, false);
    const Region lid = level(0.5, 0.5, 1.5, 1.5, 1.0, false);
    plate.holes.push_back(level(0.5, 0.5, 1.5, 1.5, 1.0, true).outline);
    const double whole = between_parallel(2, 2, 1);
    EXPECT_NEAR(form_factor(floor, plate, nothing), whole - form_factor(floor, lid, nothing), 1e-11);
}

TEST(FormFactor, the_re_entrant_corner_of_an_l_hides_its_far_walls) {
    const OccluderSet walls = occluders_of(sample::l_room());
    const Region south{{{0, 0, 0}, {0, 0, 2.5}, {4, 0, 2.5}, {4, 0, 0}}, {}};
    const Region east{{{4, 0, 2.5}, {4, 1.5, 2.5}, {4, 1.5, 0}, {4, 0, 0}}, {}};
    const Region west{{{0, 0, 0}, {0, 4, 0}, {0, 4, 2.5}, {0, 0, 2.5}}, {}};
    const Region north{{{1.5, 4, 0}, {1.5, 4, 2.5}, {0, 4, 2.5}, {0, 4, 0}}, {}};
    // composite Gauss integration of the exactly clipped factor in two orders, 1e-12
    EXPECT_NEAR(form_factor(south, north, walls), 0.03008505646602646, 1e-6 * 0.03);
    EXPECT_NEAR(form_factor(east, west, walls), 0.08022681724273721, 1e-6 * 0.08);
    EXPECT_EQ(form_factor(east, north, walls), 0.0);
}

TEST(FormFactor, is_reciprocal_past_a_box) {
    Scene scene = sample::box_room(4.0, 3.0, 2.5);
    sample::add_box(scene, {2.0, 1.5, 0.8}, {0.8, 0.5, 0.6}, 0.4);
    const OccluderSet box = occluders_of(scene);
    const Region floor = level(0, 0, 4, 3, 0.0, true);
    const Region ceiling = level(1, 1, 3, 2, 2.5, false);
    const double there = 12.0 * form_factor(floor, ceiling, box);
    const double back = 2.0 * form_factor(ceiling, floor, box);
    EXPECT_NEAR(there, back, 1e-6 * there);  // each good to 1e-7
    EXPECT_LT(there, 12.0 * form_factor(floor, ceiling, nothing));
}

}  // namespace
}  // namespace hanei
