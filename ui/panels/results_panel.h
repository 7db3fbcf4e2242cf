/// What came out, as tables.
#pragma once

#include "engine/base/diagnostic.h"
#include "engine/solution/solution.h"
#include "ui/panels/widget_registry.h"

#include <optional>

namespace hanei {

/// One line a grid and a point: mean, least, greatest, uniformity, error. Returns what was clicked.
std::optional<ObjectId> results_table(const Solution& solution, ObjectId selected, WidgetRegistry& widgets);

/// Where the luminous flux went, and how the answer was reached.
void energy_table(const Solution& solution, bool measured);

}  // namespace hanei
