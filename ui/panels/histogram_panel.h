/// How much of the area has how much light, of the chosen grid or of all surfaces.
#pragma once

#include "ui/panels/widget_registry.h"
#include "ui/view/histogram.h"

namespace hanei {

class HistogramPanel {
public:
    /// The content of its tab. `chosen`: a calculation grid; another object: all surfaces.
    void table(const SolutionSnapshot& solution, ObjectId chosen, const ViewOptions& look, WidgetRegistry& widgets);

private:
    void facts(WidgetRegistry& widgets);
    void plot(const ViewOptions& look, WidgetRegistry& widgets) const;

    struct Key {
        SolutionSnapshot solution;
        ObjectId grid;
        LightPart part = LightPart::total;
        ColourSteps steps = ColourSteps::logarithmic;
        bool operator==(const Key&) const = default;
    } key_;
    LightHistogram made_;
    std::string name_;
    std::vector<double> levels_;  ///< lx, whose shares are told
};

}  // namespace hanei
