/// Moving a calculation point by its label.
#pragma once

#include "ui/panels/object_drag.h"
#include "ui/panels/view_tool.h"

namespace hanei {

/// Holds a pin from press to release, at its height. A click alone chooses it.
class PinTool : public ViewTool {
public:
    /// Needs     a calculation point of the scene.
    PinTool(ObjectId pin, const PaneSight& sight, const SnapSettings& snap);

    Outcome handle(const PaneSight& sight) override;
    void draw(const PaneSight& sight, WidgetRegistry& widgets) const override;
    std::string hint() const override;

private:
    ObjectId pin_;
    std::optional<ObjectDrag> gesture_;  ///< empty when its plane is seen end on
    bool begun_ = false;
};

}  // namespace hanei
