/// The plot of a sweep in the window.
#pragma once

#include "engine/study/sweep.h"
#include "ui/panels/widget_registry.h"

#include <optional>

namespace hanei {

/// Takes the room that is left. Methods differ by colour and shape, the frontier is a line, what has the
/// present settings a ring; figures are told under the pointer. Points are noted as "study.point.N" in the
/// order of the sweep.
///
/// Returns   the settings of a point that was clicked; of runs without shadows between surfaces none, for a
///           project cannot be set so.
std::optional<Settings> study_plot(const Sweep& sweep, const Settings& present, WidgetRegistry& widgets);

}  // namespace hanei
