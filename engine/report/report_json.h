/// The same figures for programs.
#pragma once

#include "engine/solution/solution.h"

#include <string>

namespace hanei {

/// Values with error bars of every grid and point, figures a grid, flux balance, plan and times.
std::string values_json(const Solution& solution);

std::string plan_json(const EffectsPlan& plan);

}  // namespace hanei
