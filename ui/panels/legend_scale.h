/// What of the colour scale is changed in the legend itself.
#pragma once

#include "ui/panels/viewport.h"
#include "ui/panels/widget_registry.h"

namespace hanei {

/// The range after an end of the bar was dragged by this share of its length, upwards: in equal ratios on
/// a logarithmic scale, else in equal steps. Rounded to two digits in the shown unit; the ends stay apart.
LuxRange range_dragged(const ViewOptions& options, bool top, double share);

/// The button that names the steps, with steps, marks, levels and whose scale it is behind it.
void legend_menu(ViewState& state, bool of_project, float width, WidgetRegistry& widgets);

}  // namespace hanei
