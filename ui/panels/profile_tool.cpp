#include "ui/panels/language.h"
#include "ui/panels/profile_panel.h"
#include "ui/panels/style.h"
#include "ui/view/pick.h"

#include <cmath>
#include <imgui.h>

namespace hanei {
namespace {

constexpr double least_length = 0.02;  // m: a click alone draws nothing

}  // namespace

ViewTool::Outcome ProfileTool::handle(const PaneSight& sight) {
    Outcome outcome;
    const Ray ray = sight.pane.ray(ImGui::GetIO().MousePos);
    if (!begun_ && sight.hovered && ImGui::IsMouseClicked(ImGuiMouseButton_Left)) {
        if (const auto met = first_face(*sight.scene, ray)) begun_ = ProfileLine{met->place, met->place, met->normal};
        return outcome;
    }
    if (!begun_) return outcome;
    const double towards = glm::dot(ray.direction, begun_->normal);
    const double away = glm::dot(begun_->from - ray.origin, begun_->normal) / towards;
    if (std::isfinite(away) && away > 0.0) begun_->to = ray.origin + away * ray.direction;
    if (ImGui::IsMouseDown(ImGuiMouseButton_Left)) return outcome;
    if (begun_->length() < least_length) {  // a click: the next one ends the line
        begun_.reset();
        return outcome;
    }
    panel_.set_line(begun_);
    outcome.finished = true;
    return outcome;
}

void ProfileTool::draw(const PaneSight& sight, WidgetRegistry& /*widgets*/) const {
    if (!begun_) return;
    ImDrawList& list = *ImGui::GetWindowDrawList();
    for (const std::vector<ImVec2>& piece : sight.pane.on_screen(std::vector<Vec3>{begun_->from, begun_->to}))
        list.AddPolyline(piece.data(), static_cast<int>(piece.size()), style::accent, ImDrawFlags_None,
                         2.5F * style::scale());
}

std::string ProfileTool::hint() const {
    return tr(begun_ ? "Let go where the line ends" : "Press where the line begins, and pull; Escape lays it down");
}

}  // namespace hanei
