/// The tab in which kept solutions are listed and compared.
#pragma once

#include "ui/panels/snapshots.h"

namespace hanei {

struct CompareWish {
    bool keep_a = false, keep_b = false;     ///< the present solution
    std::optional<ObjectId> chosen{};        ///< a grid that was clicked
    std::optional<ColourScale> use_scale{};  ///< of a kept solution, for all pictures
};
CompareWish compare_panel(Snapshots& snapshots, const SolutionSnapshot& present, WidgetRegistry& widgets);

/// The scale of differences, in the legend's place; its range can be dragged and typed.
void difference_legend(Snapshots& snapshots, LightPart part, const ScreenRect& view, WidgetRegistry& widgets);

}  // namespace hanei
