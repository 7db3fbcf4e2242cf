/// Tables of a solution, as text and CSV.
#pragma once

#include "engine/solution/solution.h"

#include <string>

namespace hanei {

/// The lux table for a terminal: one line a grid (mean, min, max, U0, error), one a point, then
/// flux balance, bounces and times.
std::string summary_text(const Solution& solution);

/// Every calculation grid and point: name, place, normal, total, direct, interreflected, and the
/// error bar by its parts. Header row with units; '.' decimals whatever the locale.
std::string values_csv(const Solution& solution);

/// The plan as a table for a terminal.
std::string plan_text(const EffectsPlan& plan);

/// "412 lx" with the digits its error allows ("412.3 ± 0.8 lx").
std::string illuminance_text(Illuminance value, double error_lux);

}  // namespace hanei
