/// The unit in which illuminance is written on the screen and in pictures.
#pragma once

#include <string>
#include <string_view>

namespace hanei {

enum class IlluminanceUnit { lux, foot_candle };

/// lx in one of the unit; a foot-candle is a lumen on a square foot (0.3048 m a foot).
constexpr double lux_in(IlluminanceUnit unit) { return unit == IlluminanceUnit::lux ? 1.0 : 1.0 / (0.3048 * 0.3048); }

constexpr std::string_view name_of(IlluminanceUnit unit) { return unit == IlluminanceUnit::lux ? "lx" : "fc"; }

}  // namespace hanei
