/// Axes with units and round figures, and what is drawn between them.
#pragma once

#include "ui/panels/widget_registry.h"

#include <imgui.h>
#include <optional>
#include <string>
#include <vector>

namespace hanei {

struct PlotAxis {
    double low = 0.0, high = 1.0;
    std::string title;  ///< "Distance  m"
    bool logarithmic = false;
};

/// Takes the rest of the window's width and `height` pixels, and is noted under `name`.
class PlotFrame {
public:
    PlotFrame(const char* name, PlotAxis across, PlotAxis up, float height, WidgetRegistry& widgets);

    ImVec2 at(double x, double y) const;
    double x_at(float screen_x) const;
    ImVec2 low() const { return low_; }    ///< top left of the plot within its axes
    ImVec2 high() const { return high_; }  ///< bottom right
    bool has_room() const { return high_.x > low_.x + 20.0F && high_.y > low_.y + 20.0F; }

    /// The pointer's place on the axis across, when it is over the plot.
    std::optional<double> pointed() const { return pointed_; }

private:
    void draw_axes() const;
    double share(const PlotAxis& axis, double value) const;

    PlotAxis across_, up_;
    ImVec2 low_, high_;
    std::optional<double> pointed_;
};

/// Round figures of an axis, some `count` of them.
std::vector<double> round_figures(const PlotAxis& axis, int count);

/// Lines of text on a dark card beside a place of the plot, kept within it.
void plot_card(const PlotFrame& frame, ImVec2 at, const std::vector<std::string>& lines);

}  // namespace hanei
