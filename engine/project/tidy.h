/// Figures of a foreign file without the dust that conversion left on them: 90 degrees, not
/// 89.99999999999998, and 1.6 m, not 1.5999999999999999. Far below what single precision holds.
#pragma once

#include "engine/base/vector.h"

#include <cmath>
#include <numbers>

namespace hanei {

/// To a tenth of a nanometre; no -0.
inline double tidy_length(double metres) { return std::round(metres * 1e10) / 1e10 + 0.0; }
inline Vec3 tidy_place(const Vec3& place) { return {tidy_length(place.x), tidy_length(place.y), tidy_length(place.z)}; }

/// To 1e-8 degrees; no -0.
inline double tidy_angle(double radians) {
    constexpr double degrees = 180.0 / std::numbers::pi;
    return std::round(radians * degrees * 1e8) / 1e8 * std::numbers::pi / 180.0 + 0.0;
}

}  // namespace hanei
