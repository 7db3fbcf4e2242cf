/// What came out, as tables.
#pragma once

#include "engine/base/diagnostic.h"
#include "engine/solution/solution.h"
#include "ui/panels/widget_registry.h"

#include <optional>

namespace hanei {

/// One line a grid and a point: mean, least, greatest, uniformity, error. Returns what was clicked.
std::optional<ObjectId> results_table(const Solution& solution, ObjectId selected, WidgetRegistry& widgets);

/// What the effects plan was asked for.
struct EffectsWish {
    std::optional<Settings> settings;  ///< another choice of what is simulated
    std::optional<ObjectId> clicked;   ///< a piece of furniture
};

/// The effects plan, with the user's choice of each effect that may be skipped. `measured` shows what each
/// effect took; pictures that shall repeat leave it out.
EffectsWish effects_table(const EffectsPlan& plan, const Settings& settings, bool measured, WidgetRegistry& widgets);

/// Where the luminous flux went, and how the answer was reached.
void energy_table(const Solution& solution, bool measured);

}  // namespace hanei
