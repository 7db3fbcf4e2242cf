/// The arc tangent, fast enough for the innermost loops.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>

namespace hanei {

namespace arc_tangent_table {

constexpr std::size_t steps = 32;

/// Arc tangents of 0, 1/32 ... 1.
inline const std::array<double, steps + 1> angles = [] {
    std::array<double, steps + 1> made{};
    for (std::size_t k = 0; k <= steps; ++k) made[k] = std::atan(static_cast<double>(k) / steps);
    return made;
}();

/// An angle from the nearest axis to the angle from (1, 0), for y not below 0: looked up, as branches
/// here would be taken at random.
struct Eighth {
    double base, sign;
};
constexpr std::array<Eighth, 4> eighths = {
    {{0.0, 1.0}, {0.5 * std::numbers::pi, -1.0}, {std::numbers::pi, -1.0}, {0.5 * std::numbers::pi, 1.0}}};

}  // namespace arc_tangent_table

/// Angle from (1, 0) to (x, y), -pi to pi, as std::atan2: the nearest tabulated angle and the arc
/// tangent of the rest, at most 1/64, by its series (the term left out is under 1e-20).
///
/// Needs     finite components, neither so great nor so small that 32 times it overflows.
/// Returns   0 for (0, 0).
/// Holds     4e-16 of the angle.
/// Cost      two divisions, no branch on the direction.
inline double arc_tangent(double y, double x) {
    const double up = std::abs(y), along = std::abs(x);
    const bool steep = up > along;
    const double less = std::min(up, along), more = std::max(up, along);
    if (!(more > 0.0)) return 0.0;
    constexpr auto steps = static_cast<double>(arc_tangent_table::steps);
    const auto step = static_cast<int>(steps * (less / more) + 0.5);
    const double nearest = static_cast<double>(step) / steps;
    const double rest = (less - nearest * more) / (more + nearest * less);
    const double s = rest * rest;
    const double series = rest * (1.0 - s * (1.0 / 3.0 - s * (1.0 / 5.0 - s * (1.0 / 7.0 - s / 9.0))));
    const double angle = arc_tangent_table::angles[static_cast<std::size_t>(step)] + series;
    const arc_tangent_table::Eighth& eighth = arc_tangent_table::eighths[(x < 0.0 ? 2 : 0) + (steep ? 1 : 0)];
    return std::copysign(eighth.base + eighth.sign * angle, y);
}

/// Angle between two vectors over the length of their cross product, from that length's square and
/// the dot product: what Lambert's sum asks of every edge. Under 0.2 rad by the series in the
/// tangent's square, which needs no root and cancels nothing (the term left out is under 1e-17).
///
/// Needs     a square above zero.
inline double angle_over_cross(double square, double dot) {
    if (dot > 0.0 && square < 0.04 * dot * dot) {
        const double inverse = 1.0 / dot;
        const double s = square * inverse * inverse;
        double series = 1.0 / 21.0;
        for (int denominator = 19; denominator > 0; denominator -= 2) series = 1.0 / denominator - s * series;
        return series * inverse;
    }
    const double cross_length = std::sqrt(square);
    return arc_tangent(cross_length, dot) / cross_length;
}

}  // namespace hanei
