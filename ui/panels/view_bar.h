/// The row above the view (which light, in which colours) and the scale over it.
#pragma once

#include "ui/panels/saved_views.h"
#include "ui/panels/viewport.h"
#include "ui/panels/widget_registry.h"

namespace hanei {

/// Returns   the scene with its kept views changed, when that was asked for.
std::optional<ViewEdit> view_bar(ViewState& state, const Scene& scene, const SolutionSnapshot& solution,
                                 WidgetRegistry& widgets);

/// Before an item of this width that stands in the bar behind those of view_bar(): goes to the next row
/// when it has no room. end_view_bar() comes after the last one.
void flow_in_view_bar(float width);
void end_view_bar();

/// With its margins: of one row, or of more where the last frame needed them.
float view_bar_height();

/// Pixels that the scale takes at the right of the view.
float legend_margin();

/// The colour scale in the top right corner of the given rectangle, to be changed there. Nothing for photos.
/// `of_project`: it is kept with the project.
void legend(ViewState& state, bool of_project, const ScreenRect& view, WidgetRegistry& widgets);

/// The key to the shadow classes in its place, with whose shadows they are and how much each holds.
void class_legend(const ViewOptions& look, const SolutionSnapshot& solution, const ScreenRect& view,
                  WidgetRegistry& widgets);

}  // namespace hanei
