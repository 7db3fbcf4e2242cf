#include "ui/panels/box_tool.h"

#include "ui/panels/language.h"
#include "ui/panels/style.h"
#include "ui/view/pick.h"

#include <cmath>

namespace hanei {
namespace {

constexpr float click_slack = 4.0F;  // pixels a click may move and still be a click

}  // namespace

ViewTool::Outcome BoxTool::handle(const PaneSight& sight) {
    const ImGuiIO& io = ImGui::GetIO();
    Outcome outcome;
    if (!from_) {
        if (sight.hovered && ImGui::IsMouseClicked(ImGuiMouseButton_Left)) from_ = io.MousePos;
        return outcome;
    }
    if (io.MouseDown[ImGuiMouseButton_Left]) return outcome;
    outcome.finished = true;
    const bool clicked = std::hypot(io.MousePos.x - from_->x, io.MousePos.y - from_->y) < click_slack;
    if (clicked) {
        const ObjectId hit = pick(*sight.scene, sight.pane.camera, sight.pane.within(io.MousePos), sight.pane.aspect());
        outcome.chosen =
            chosen_by_click(*sight.scene, sight.selection, hit, {io.KeyShift || io.KeyCtrl, io.KeyAlt, false});
        return outcome;
    }
    const BoxManner manner = io.KeyCtrl ? BoxManner::takes : io.KeyShift ? BoxManner::adds : BoxManner::replaces;
    outcome.chosen = chosen_by_box(*sight.scene, sight.selection,
                                   objects_in_box(*sight.scene, sight.pane, *from_, io.MousePos, with_points_), manner);
    return outcome;
}

void BoxTool::draw(const PaneSight& sight, WidgetRegistry&) const {
    const ImVec2 mouse = ImGui::GetIO().MousePos;
    if (!from_ || !sight.pane.holds(*from_)) return;
    const bool wholly = from_->x <= mouse.x;
    const float scale = style::scale();
    const ImVec2 low{std::min(from_->x, mouse.x), std::min(from_->y, mouse.y)};
    const ImVec2 high{std::max(from_->x, mouse.x), std::max(from_->y, mouse.y)};
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const ImU32 line = wholly ? style::axis_z : style::axis_y;
    list.AddRectFilled(low, high, (line & 0x00FFFFFFU) | 0x28000000U);
    if (wholly) return list.AddRect(low, high, line, 0.0F, 0, 1.2F * scale);
    const float dash = 6.0F * scale;  // dashed: what it only touches counts as well
    for (float x = low.x; x < high.x; x += 2.0F * dash) {
        list.AddLine({x, low.y}, {std::min(x + dash, high.x), low.y}, line, 1.2F * scale);
        list.AddLine({x, high.y}, {std::min(x + dash, high.x), high.y}, line, 1.2F * scale);
    }
    for (float y = low.y; y < high.y; y += 2.0F * dash) {
        list.AddLine({low.x, y}, {low.x, std::min(y + dash, high.y)}, line, 1.2F * scale);
        list.AddLine({high.x, y}, {high.x, std::min(y + dash, high.y)}, line, 1.2F * scale);
    }
}

std::string BoxTool::hint() const {
    return tr(
        "Drag a box: to the right takes what it encloses, to the left what it touches. Shift adds, Ctrl takes away");
}

}  // namespace hanei
