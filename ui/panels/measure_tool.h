/// Measures the distance of two places in a picture.
#pragma once

#include "ui/panels/measure_points.h"
#include "ui/panels/view_tool.h"

namespace hanei {

/// A click begins, another ends; a third begins anew. Both catch at corners, edges, centres and the raster;
/// Ctrl frees them. In a drawing (plan, front, side) the distance is the one in the drawing: what lies along
/// the line of sight does not count.
class MeasureTool : public ViewTool {
public:
    Outcome handle(const PaneSight& sight) override;
    void draw(const PaneSight& sight, WidgetRegistry& widgets) const override;
    std::string hint() const override;

    /// The distance between the places, or to the pointer; nothing before the first click.
    std::optional<Vec3> distance() const;

private:
    std::optional<Vec3> first_, second_;
    std::optional<MeasurePoint> under_;  ///< the pointer
    struct Kept {
        SceneSnapshot scene;
        MeasureMarks marks;
    } kept_;
};

}  // namespace hanei
