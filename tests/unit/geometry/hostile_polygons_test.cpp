/// Form factors of the polygons that are hardest on the contour sum, against 33 digits. Set
/// HANEI_HOSTILE to a number of cases a class for the whole table.
#include "engine/geometry/configuration_factor.h"
#include "tests/hostile.h"
#include "tests/quad_precision.h"
#include "tests/unit/geometry/shapes.h"

#include <gtest/gtest.h>
#include <numbers>

namespace hanei {
namespace {

using testing::Dice;
using testing::Errors;

struct Case {
    Polygon polygon;
    Receiver receiver;
};

double power(Dice& dice, double low, double high) { return std::pow(10.0, dice.uniform(low, high)); }

/// Three to six corners around the middle, `squeeze` as wide as long, in the plane spanned by turn's
/// first two axes; the front looks along the third.
Polygon around(Dice& dice, const Vec3& middle, const Mat3& turn, double size, double squeeze = 1.0) {
    Polygon polygon;
    const int corners = 3 + static_cast<int>(dice.uniform(0, 4));
    for (int k = 0; k < corners; ++k) {
        const double angle = 2 * std::numbers::pi * (k + dice.uniform(0, 0.8)) / corners;
        polygon.push_back(middle + turn * (0.5 * size * Vec3{std::cos(angle), squeeze * std::sin(angle), 0}));
    }
    return polygon;
}

Mat3 facing(Dice& dice, const Vec3& direction) {
    const Mat3 turn = dice.rotation();
    return glm::dot(turn[2], direction) < 0 ? Mat3{turn[1], turn[0], -turn[2]} : turn;
}

/// A polygon of this size at this distance from a receiver within `reach` of the scene's origin.
Case at_distance(Dice& dice, double size, double distance, double reach, double squeeze = 1.0) {
    const Vec3 eye = dice.place(reach), direction = dice.direction();
    return {around(dice, eye + distance * direction, facing(dice, -direction), size, squeeze),
            {eye, dice.direction(), Vec3{0}}};
}

Case generic(Dice& dice) { return at_distance(dice, dice.uniform(0.1, 3), 1, 3); }
Case small_far(Dice& dice) { return at_distance(dice, power(dice, -3, -1), 1, 3); }
Case tiny_far(Dice& dice) { return at_distance(dice, power(dice, -6, -3), 1, 0.01); }
Case far_from_the_origin(Dice& dice) { return at_distance(dice, dice.uniform(0.1, 3), 1, 1e5); }
Case huge(Dice& dice) { return at_distance(dice, 1000, 1, 3); }
Case sliver(Dice& dice) { return at_distance(dice, dice.uniform(0.1, 3), 1, 3, 1e-6); }

Case near_the_plane(Dice& dice) {
    const Mat3 turn = dice.rotation();
    const Vec3 eye = dice.place(3);
    const Vec3 aside = turn * Vec3{dice.uniform(-1, 1), dice.uniform(-1, 1), -power(dice, -8, -3)};
    return {around(dice, eye + aside, turn, dice.uniform(0.5, 2)), {eye, dice.direction(), Vec3{0}}};
}

/// The place of an edge of the polygon, 0 at its start, 1 at its end.
Vec3 on_edge(const Polygon& polygon, double t) { return polygon[0] + t * (polygon[1] - polygon[0]); }

Case near_an_edge(Dice& dice) {
    const Mat3 turn = dice.rotation();
    const Polygon polygon = around(dice, dice.place(3), turn, dice.uniform(0.5, 2));
    Vec3 away = turn[2];  // steep enough not to be in the plane as tolerance::touching sees it
    while (std::abs(glm::dot(away, turn[2])) > 0.99 || glm::dot(away, turn[2]) < 0.1) away = dice.direction();
    const Vec3 eye = on_edge(polygon, dice.uniform(0.05, 0.95)) + power(dice, -9, -3) * away;
    return {polygon, {eye, dice.direction(), Vec3{0}}};
}

Case in_line_with_an_edge(Dice& dice) {
    const Mat3 turn = dice.rotation();
    const Polygon polygon = around(dice, dice.place(3), turn, dice.uniform(0.5, 2));
    const double lift = power(dice, -9, -3);
    const Vec3 eye = on_edge(polygon, dice.uniform(1.05, 3)) + lift * turn[2];
    return {polygon, {eye, dice.direction(), Vec3{0}}};
}

Case near_duplicates(Dice& dice) {
    Case made = generic(dice);
    Polygon doubled;
    for (const Vec3& corner : made.polygon) {
        doubled.push_back(corner);
        if (dice.uniform(0, 1) < 0.5) doubled.push_back(corner + 1e-7 * (made.polygon[0] - corner));
        if (dice.uniform(0, 1) < 0.1) doubled.push_back(doubled.back());
    }
    made.polygon = doubled;
    return made;
}

Case grazing(Dice& dice) {
    Case made = generic(dice);
    const Vec3 corner = made.polygon[0] - made.receiver.position;
    const Vec3 upright = glm::normalize(glm::cross(corner, dice.direction()));
    made.receiver.normal = glm::normalize(upright + power(dice, -12, -2) * dice.direction());
    return made;
}

/// How far one rounding of what the receiver sees moves the form factor: of the way to the first
/// corner, of the offsets from there, of the normal. The greatest of three throws.
double moved_by_rounding(const Case& made, double exact, Dice& dice) {
    constexpr double half = 0x1p-53;
    double moved = half * exact;
    for (int k = 0; k < 3; ++k) {
        const Vec3 shift = half * glm::distance(made.polygon[0], made.receiver.position) * dice.direction();
        std::vector<testing::QuadVec> shaken;
        const testing::QuadVec at(made.receiver.position);
        for (const Vec3& corner : made.polygon) {
            const Vec3 offset = half * glm::distance(corner, made.polygon[0]) * dice.direction();
            shaken.push_back(testing::QuadVec(corner) - at + testing::QuadVec(shift) + testing::QuadVec(offset));
        }
        const testing::QuadVec normal =
            testing::QuadVec(made.receiver.normal) + testing::QuadVec(half * dice.direction());
        moved = std::max(moved, std::abs(static_cast<double>(testing::quad_factor(shaken, normal)) - exact));
    }
    return moved;
}

struct Class {
    const char* name;
    Case (*make)(Dice&);
    double median, p99;       ///< limits of the relative error
    double well_conditioned;  ///< of the greatest relative error where rounding the input moves F by 1e-15
    double absolute;          ///< of the greatest absolute error
};

// Limits are about three times what 100,000 cases a class give. Where median and p99 are great, F itself
// is nothing (near the plane, slivers, tips over the horizon) or the input's rounding is all of it: 1e-16
// of a metre over the 1e-9 m to an edge. The absolute error is then what counts.
const Class classes[] = {
    {"generic", generic, 1e-15, 2e-13, 1e-12, 3e-14},
    {"small far", small_far, 1e-15, 3e-14, 1e-14, 3e-18},
    {"tiny far", tiny_far, 1e-15, 2e-14, 1e-14, 3e-22},
    {"just above the plane", near_the_plane, 1e-11, 2e-7, 1e-13, 2e-12},
    {"near an edge", near_an_edge, 1e-10, 2e-6, 1e-9, 1e-6},
    {"in line with an edge", in_line_with_an_edge, 1e-9, 1e-5, 1e-12, 1e-15},
    {"near-duplicate corners", near_duplicates, 1e-15, 2e-13, 1e-12, 3e-14},
    {"sliver 1e6 to 1", sliver, 1e-9, 1e-7, 1e-12, 2e-15},
    {"grazing the horizon", grazing, 1e-14, 1, 1e-12, 1e-14},
    {"1e5 m from the origin", far_from_the_origin, 1e-15, 2e-13, 1e-12, 1e-14},
    {"1000 distances wide", huge, 1e-15, 1e-12, 1e-12, 3e-13},
};

TEST(HostilePolygons, keep_the_digits_that_their_coordinates_hold) {
    for (const Class& each : classes) {
        Dice dice(3);
        Errors errors;
        for (int k = testing::hostile_count(2000); k > 0; --k) {
            const Case made = each.make(dice);
            const auto exact = static_cast<double>(testing::quad_factor(made.polygon, made.receiver));
            errors.add(configuration_factor(made.polygon, made.receiver), exact, moved_by_rounding(made, exact, dice));
        }
        errors.print(each.name);
        EXPECT_EQ(errors.broken, 0) << each.name;
        EXPECT_LT(errors.relative(0.5), each.median) << each.name;
        EXPECT_LT(errors.relative(0.99), each.p99) << each.name;
        EXPECT_LT(errors.absolute, each.absolute) << each.name;
        EXPECT_LT(errors.well_conditioned, each.well_conditioned) << each.name;
    }
}

/// Polygons on a lattice of 2^-20 m, the receiver exactly in their plane, on an edge or on a corner of
/// them: against the value a little way along `inward`, or towards the front.
TEST(HostilePolygons, touching_the_receiver_give_the_limit) {
    Dice dice(5);
    Errors errors;
    const auto lattice = [](const Vec3& v) { return glm::round(v * 1024.0) / 1024.0; };
    for (int k = testing::hostile_count(2000); k > 0; --k) {
        const Vec3 across = lattice(dice.place(1)), up = lattice(dice.place(1)), middle = lattice(dice.place(3));
        if (glm::length(glm::cross(across, up)) < 0.05) continue;
        const Polygon polygon{middle - across - up, middle + across - up, middle + across + up, middle - across + up};
        const Vec3 front = glm::normalize(glm::cross(across, up));
        const double kind = dice.uniform(0, 3);
        Vec3 place = polygon[0];
        if (kind < 1) place = 0.5 * (polygon[0] + polygon[1]);
        if (kind > 2) place = middle + 0.25 * across - 0.5 * up;
        const Vec3 normal = dice.direction();
        const Vec3 rising = glm::normalize(front - glm::dot(front, normal) * normal);
        Vec3 inward{0.0};
        if (dice.uniform(0, 1) < 0.5) inward = glm::normalize(glm::cross(normal, dice.direction()));
        const Receiver receiver{place, normal, inward};
        const Vec3 beside = inward == Vec3{0.0} ? rising : inward;
        if (std::abs(glm::dot(beside, front)) < 0.01) continue;  // neither in front nor behind
        const testing::QuadVec aside = testing::Quad(1e-20) * testing::QuadVec(beside);
        const auto limit = static_cast<double>(testing::quad_factor(polygon, receiver, aside));
        errors.add(configuration_factor(polygon, receiver), limit, 0.0);
    }
    errors.print("touching the receiver");
    EXPECT_EQ(errors.broken, 0);
    EXPECT_LT(errors.absolute, 1e-13);  // the way of 1e-20 m, and angles of up to a turn
}

}  // namespace
}  // namespace hanei
