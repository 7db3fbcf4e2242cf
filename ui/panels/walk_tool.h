/// Walking through the room, the eye at the height of a person's.
#pragma once

#include "ui/panels/viewport.h"
#include "ui/panels/walking.h"

namespace hanei {

/// W A S D and the up and down arrows walk, the left and right ones turn, a drag looks around, the wheel
/// steps; Shift walks faster, Q and E (or Page Down and Up) lower and raise the eye. A right click, or a
/// picture that is to scale, ends it. The camera stays where the walk ended.
///
/// Holds     only how the walker is held: place and gaze are those of the present camera, so that a view
///           that is recalled meanwhile is walked on from.
class WalkTool : public ViewTool {
public:
    /// Takes the active picture's camera into the room, all of which is there.
    WalkTool(ViewState& state, const Scene& scene);

    Outcome handle(const PaneSight& sight) override;
    void draw(const PaneSight& sight, WidgetRegistry& widgets) const override;
    bool takes(const Chord& chord) const override;
    bool turns_view() const override { return true; }
    bool is_moving() const override { return moves_; }
    std::string hint() const override;

private:
    void look(Walker& walker);
    void walk(Walker& walker, const PaneSight& sight);
    std::string readout(const Scene& scene) const;

    ViewState& state_;
    bool moves_ = false;  ///< a key is held
    bool is_held_ = false;
    bool looks_ = false;  ///< a button went down in the picture
    ImVec2 pressed_at_{0.0F, 0.0F};
};

}  // namespace hanei
