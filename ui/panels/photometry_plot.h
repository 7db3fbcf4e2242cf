/// The drawing of a luminaire's curves: polar or over the angle, with a read-out under the pointer.
#pragma once

#include "ui/panels/photometry_curves.h"
#include "ui/panels/widget_registry.h"

#include <imgui.h>
#include <optional>
#include <string>
#include <vector>

namespace hanei {

/// One plane as it is drawn.
struct PlaneCurve {
    double plane_deg = 0.0;
    bool dashed = false;
    ImU32 colour = 0;
    std::vector<CurvePoint> points;  ///< candela
};

struct PlotRequest {
    std::vector<PlaneCurve> curves;  ///< at least one
    double peak = 0.0;               ///< candela, of all the light: the scale stays when another plane is chosen
    double factor = 1.0;             ///< from candela to the unit that is shown
    bool upward = false;             ///< there is light above the horizontal to show
};

/// The signed gamma the pointer is at, in half degrees.
using HoveredGamma = std::optional<double>;

/// Both take the whole width that is left and note the widget "photometry.plot".
HoveredGamma polar_plot(const PlotRequest& request, WidgetRegistry& widgets);
HoveredGamma cartesian_plot(const PlotRequest& request, WidgetRegistry& widgets);

/// A curve's stroke, for a legend: solid or dashed as in the plots.
void stroke(ImDrawList& list, const std::vector<ImVec2>& places, const PlaneCurve& look);

std::string figure_on_axis(double value);  ///< "1500", "0.25": no digits that say nothing

}  // namespace hanei
