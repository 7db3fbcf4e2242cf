/// Draws the plan of a room in the view: corner by corner, by click or by typed lengths.
#pragma once

#include "ui/panels/view_tool.h"

#include <vector>

namespace hanei {

/// A click sets a corner on the raster; Shift keeps the wall to multiples of 15°. Digits type the length
/// of the next wall in the pointer's direction. Enter, a double click or a click on the first corner
/// closes the plan; Backspace takes the last digit or corner back. Walls that cross are refused.
class PlanTool : public ViewTool {
public:
    explicit PlanTool(double floor) : floor_(floor) {}

    Outcome handle(const PaneSight& sight) override;
    void draw(const PaneSight& sight, WidgetRegistry& widgets) const override;
    std::string hint() const override;
    bool takes(const Chord& chord) const override;

    const std::vector<Vec2>& corners() const { return corners_; }

private:
    Vec2 aimed(const PaneSight& sight, const Vec2& pointer) const;
    void read_typing();
    bool on_first(const PaneSight& sight) const;
    void add(const Vec2& corner);
    Outcome close(const Scene& scene);

    double floor_;
    std::vector<Vec2> corners_;
    std::optional<Vec2> next_;  ///< where a click would set the next corner
    std::string typed_;         ///< m
    std::string fault_;         ///< why the last click was refused
};

}  // namespace hanei
