#include "ui/panels/pin_tool.h"

#include "ui/panels/handles.h"
#include "ui/panels/language.h"

#include <imgui.h>

namespace hanei {
namespace {

constexpr float click_slack = 4.0F;  // pixels a click may move and still be a click
constexpr double reach = 1e3;        // m
constexpr double caught = 8.0;       // pixels to a line that catches

}  // namespace

PinTool::PinTool(ObjectId pin, const PaneSight& sight, const SnapSettings& snap)
    : pin_(pin),
      gesture_(ObjectDrag::begin(sight.scene, {pin}, Grip::plane_xy, sight.pane.ray(ImGui::GetIO().MousePos), reach,
                                 snap)) {}

ViewTool::Outcome PinTool::handle(const PaneSight& sight) {
    Outcome outcome;
    begun_ |= gesture_ && ImGui::IsMouseDragging(ImGuiMouseButton_Left, click_slack);
    if (begun_) {
        ObjectDrag::Keys keys;
        keys.frees = ImGui::GetIO().KeyCtrl;
        const double a_pixel =
            picture_height_at(sight.pane.camera, gesture_->place()) / static_cast<double>(sight.pane.height);
        outcome.scene = gesture_->at(sight.pane.ray(ImGui::GetIO().MousePos), keys, caught * a_pixel);
        outcome.step = gesture_->step();
    }
    if (ImGui::IsMouseDown(ImGuiMouseButton_Left)) return outcome;
    outcome.settles = begun_;
    outcome.chosen = Selection(pin_);
    outcome.finished = true;
    return outcome;
}

void PinTool::draw(const PaneSight& sight, WidgetRegistry& /*widgets*/) const {
    if (begun_) draw_guides(sight.pane, *gesture_);
}

std::string PinTool::hint() const { return tr("Drag; Ctrl leaves the raster, or keeps to it"); }

}  // namespace hanei
