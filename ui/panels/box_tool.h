/// Chooses what lies in a box drawn over the picture.
#pragma once

#include "ui/panels/choosing.h"
#include "ui/panels/view_tool.h"

namespace hanei {

/// From left to right what lies wholly in the box, from right to left what it touches. Shift adds to
/// what is chosen, Ctrl with it takes away. A click without a box counts as a click on an object.
class BoxTool : public ViewTool {
public:
    /// `held` at the place where the button was pressed already; else it waits for the press.
    explicit BoxTool(bool with_points, std::optional<ImVec2> held = std::nullopt)
        : with_points_(with_points), from_(held) {}

    Outcome handle(const PaneSight& sight) override;
    void draw(const PaneSight& sight, WidgetRegistry& widgets) const override;
    std::string hint() const override;

private:
    bool with_points_;
    std::optional<ImVec2> from_;
};

}  // namespace hanei
