/// Carries a piece of the furniture library to its place in the room.
#pragma once

#include "ui/panels/view_tool.h"

namespace hanei {

/// A ghost follows the pointer: over the floor, over furniture for what stands on it, its back to a wall
/// that is near. A click or Enter places it, with Ctrl another one follows; R turns it by 90°, Shift+R by
/// 15°. Dragged from the library, it is placed where the button is let go.
class PlaceTool : public ViewTool {
public:
    PlaceTool(FurnitureModel model, bool dragged) : model_(std::move(model)), dragged_(dragged) {}

    Outcome handle(const PaneSight& sight) override;
    void draw(const PaneSight& sight, WidgetRegistry& widgets) const override;
    std::string hint() const override;
    bool takes(const Chord& chord) const override;

private:
    void aim(const PaneSight& sight);
    Outcome place(const PaneSight& sight);

    FurnitureModel model_;
    bool dragged_;
    bool turned_ = false;  ///< by hand: walls turn it no longer
    double rotation_ = 0.0;
    std::optional<Scene> ghost_;  ///< the piece alone, where it would stand
    std::optional<Vec3> at_;
    bool stands_free_ = true;
};

}  // namespace hanei
