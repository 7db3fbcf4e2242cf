/// Angles of four vectors at once, by arithmetic and roots alone.
#pragma once

#include "engine/geometry/quartet.h"

#include <array>
#include <numbers>

namespace hanei {

/// (arc tangent of t over t, less one) / t^2 from s = t^2 up to tan(pi/8)^2: interpolated at Chebyshev's
/// nodes, 4e-18.
HANEI_QUARTET Quartet arc_tangent_series(const Quartet& s) {
    constexpr std::array<double, 12> c = {-0.3333333333333333,  0.19999999999999804,   -0.14285714285659828,
                                          0.11111111105155447,  -0.09090908753500877,  0.07692296375032143,
                                          -0.06666424885738255, 0.05878928997834775,   -0.05230454270650244,
                                          0.04551593220626549,  -0.034570561981427744, 0.016285756855221028};
    const Quartet s2 = s * s, s4 = s2 * s2;
    const Quartet first = (c[0] + s * c[1]) + s2 * (c[2] + s * c[3]);
    const Quartet second = (c[4] + s * c[5]) + s2 * (c[6] + s * c[7]);
    const Quartet third = (c[8] + s * c[9]) + s2 * (c[10] + s * c[11]);
    return first + s4 * (second + s4 * third);
}

/// Angles from (1, 0) to (x, y), 0 to pi, of vectors of any length.
///
/// Needs     y above 0; squares that do not overflow.
/// Holds     a few roundings of the angle.
HANEI_QUARTET Quartet angles_above(const Quartet& y, const Quartet& x) {
    const Quartet away = x < 0.0 ? -x : x;
    const Quartet half = y / (root(x * x + y * y) + away);  // the tangent of half the angle, or of its supplement's
    const Quartet quarter = half / (1.0 + root(1.0 + half * half));
    const Quartet square = quarter * quarter;
    const Quartet acute = 4.0 * quarter * (1.0 + square * arc_tangent_series(square));
    return x < 0.0 ? std::numbers::pi - acute : acute;
}

}  // namespace hanei
