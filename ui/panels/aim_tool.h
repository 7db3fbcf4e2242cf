/// Turns luminaires at a place that is pointed at in the view.
#pragma once

#include "ui/panels/view_tool.h"

#include <vector>

namespace hanei {

/// Press on a surface and the luminaires turn there; drag, and they follow; let go, and it is one step.
class AimTool : public ViewTool {
public:
    explicit AimTool(std::vector<ObjectId> luminaires) : luminaires_(std::move(luminaires)) {}

    Outcome handle(const PaneSight& sight) override;
    void draw(const PaneSight& sight, WidgetRegistry& widgets) const override;
    std::string hint() const override;

private:
    std::vector<ObjectId> luminaires_;
    std::optional<Vec3> target_;  ///< under the pointer
    bool aiming_ = false;
};

/// What the step is called: "Aim luminaire", "Aim 3 luminaires".
std::string aim_step(std::size_t luminaires);

}  // namespace hanei
