#include "ui/panels/aim_tool.h"

#include "engine/edit/aiming.h"
#include "engine/edit/luminaire_edits.h"
#include "ui/panels/language.h"
#include "ui/panels/style.h"
#include "ui/view/pick.h"

#include <algorithm>
#include <fmt/format.h>
#include <imgui.h>

namespace hanei {

std::string aim_step(std::size_t luminaires) {
    return luminaires == 1 ? std::string("Aim luminaire") : fmt::format("Aim {} luminaires", luminaires);
}

ViewTool::Outcome AimTool::handle(const PaneSight& sight) {
    Outcome outcome;
    const bool none_left = std::none_of(luminaires_.begin(), luminaires_.end(),
                                        [&](ObjectId id) { return find_luminaire(*sight.scene, id) != nullptr; });
    outcome.finished = none_left;
    if (none_left) return outcome;
    if (sight.hovered || aiming_) {
        const auto met = first_face(*sight.scene, sight.pane.ray(ImGui::GetIO().MousePos));
        if (met)
            target_ = met->place;
        else if (!aiming_)
            target_.reset();
    } else {
        target_.reset();
    }
    if (sight.hovered && target_ && ImGui::IsMouseClicked(ImGuiMouseButton_Left)) aiming_ = true;
    if (!aiming_) return outcome;
    if (target_) {
        Scene wished = aimed(*sight.scene, luminaires_, *target_);
        if (!(wished == *sight.scene)) outcome.scene = std::move(wished);
        outcome.step = aim_step(luminaires_.size());
    }
    if (ImGui::IsMouseDown(ImGuiMouseButton_Left)) return outcome;
    aiming_ = false;
    outcome.settles = outcome.finished = true;
    return outcome;
}

void AimTool::draw(const PaneSight& sight, WidgetRegistry&) const {
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const float scale = style::scale();
    const ImU32 ink = style::accent, shade = IM_COL32(0, 0, 0, 0x90);
    const auto line = [&](const Vec3& from, const Vec3& to, float width) {
        for (const auto& piece : sight.pane.on_screen(std::vector<Vec3>{from, to})) {
            list.AddPolyline(piece.data(), static_cast<int>(piece.size()), shade, 0, (width + 2.0F) * scale);
            list.AddPolyline(piece.data(), static_cast<int>(piece.size()), ink, 0, width * scale);
        }
    };
    for (const ObjectId id : luminaires_) {
        const Luminaire* const luminaire = find_luminaire(*sight.scene, id);
        if (!luminaire) continue;
        if (target_) {
            line(luminaire->position, *target_, 1.6F);
        } else {
            constexpr double shown = 1.0;  // m of the beam, before a place is pointed at
            line(luminaire->position, luminaire->position + shown * beam_in_scene(*sight.scene, *luminaire), 1.6F);
        }
    }
    if (!target_) return;
    const auto at = sight.pane.on_screen(*target_);
    if (!at) return;
    const float radius = 6.0F * scale;
    list.AddCircle(*at, radius + 1.0F, shade, 0, 3.5F * scale);
    list.AddCircle(*at, radius, ink, 0, 1.8F * scale);
    list.AddCircleFilled(*at, 2.0F * scale, ink);
}

std::string AimTool::hint() const {
    if (aiming_ && target_) return fmt::format("x {:.2f}  y {:.2f}  z {:.2f} m", target_->x, target_->y, target_->z);
    return tr("Click the place to shine at; drag to try places; Esc ends");
}

}  // namespace hanei
