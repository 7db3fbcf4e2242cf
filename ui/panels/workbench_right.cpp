#include "engine/edit/several.h"
#include "ui/panels/language.h"
#include "ui/panels/panel_frame.h"
#include "ui/panels/properties.h"
#include "ui/panels/style.h"
#include "ui/panels/workbench.h"

#include <fmt/format.h>
#include <imgui_internal.h>

namespace hanei {
namespace {

std::string step_name(const Scene& scene, const Selection& selection) {
    ObjectIds alike = others_alike(scene, selection);
    alike.push_back(selection.primary());
    return "Change " + (selection.empty() ? std::string("project") : words_for(scene, alike));
}

/// "4 luminaires", and which of a mixed selection the rows below are about.
void several_headline(const Scene& scene, const Selection& selection) {
    ObjectIds alike = others_alike(scene, selection);
    alike.push_back(selection.primary());
    const std::string all = words_for(scene, selection.ids());
    const bool mixed_kinds = alike.size() < selection.ids().size();
    headline(all, mixed_kinds ? fmt::format("{} {}", tr("below:"), words_for(scene, alike)) : std::string());
}

}  // namespace

void Workbench::properties_tab() {
    const SceneSnapshot scene = document_.shown();
    const ObjectKind kind = kind_of(*scene, selection_.primary());
    ImGui::Dummy({0.0F, 2.0F * style::scale()});
    if (kind == ObjectKind::none)
        headline(tr("Project"), "");
    else if (selection_.ids().size() == 1)
        headline(display_name(*scene, selection_.primary()), tr(name_of(kind)));
    else
        several_headline(*scene, selection_);
    if (kind == ObjectKind::room) return room_tab();
    ImGui::PushID(static_cast<int>(selection_.primary().value));
    form_.begin("properties");
    std::optional<Scene> wished = several_panel_.draw(scene, selection_, form_);
    form_.end();
    ImGui::PopID();
    if (!wished) return;
    // The picture follows a view that it shows.
    const auto camera_in = [&](const Scene& each) {
        for (const View& view : each.views)
            if (view.id == selection_.primary()) return std::optional(camera_of(view));
        return std::optional<Camera>();
    };
    if (camera_in(*scene) == viewport_.state.camera) viewport_.state.camera = *camera_in(*wished);
    propose(std::move(*wished), step_name(*scene, selection_));
}

void Workbench::room_tab() {
    form_.begin("room");
    std::optional<Scene> wished = room_panel(*document_.shown(), furnishing_.room, form_);
    form_.end();
    if (wished) propose(std::move(*wished), furnishing_.room.made ? "Add to the room" : "Change room");
    if (furnishing_.room.made) selection_.choose(furnishing_.room.made);
    if (furnishing_.room.draws_plan) carry_out(CommandId::draw_plan);
}

void Workbench::furniture_tab() {
    Furnishing::Wish wish = furnishing_.library(*document_.shown(), selection_.primary(), widgets_);
    if (wish.scene || wish.tool) document_.settle();  // what was being changed stays
    furnishing_wish(std::move(wish));
}

void Workbench::photometry_tab() {
    ImGui::PushID(static_cast<int>(selection_.primary().value));
    PhotometryPanel::Outcome outcome = photometry_.draw(*document_.shown(), selection_.primary(), form_);
    ImGui::PopID();
    if (outcome.edit) propose(std::move(outcome.edit->scene), std::move(outcome.edit->step));
    if (outcome.replaces_file) replace_luminaire_file();
}

void Workbench::right(const ScreenRect& area) {
    begin_panel("##right", area);
    movable_edge(Edge::left, area, preferences_.right_width, 220.0F, 520.0F);
    if (begin_tabs("sides")) {
        if (begin_tab("Properties", widgets_)) {
            ImGui::BeginChild("fields");
            properties_tab();
            ImGui::EndChild();
            ImGui::EndTabItem();
        }
        if (begin_tab("Photometry", widgets_)) {
            ImGui::BeginChild("photometry");
            photometry_tab();
            ImGui::EndChild();
            ImGui::EndTabItem();
        }
        if (begin_tab("Light", widgets_)) {
            ImGui::BeginChild("light");
            light_tab();
            ImGui::EndChild();
            ImGui::EndTabItem();
        }
        if (begin_tab("Calculation", widgets_)) {
            ImGui::BeginChild("settings");
            ImGui::Dummy({0.0F, 2.0F * style::scale()});
            form_.begin("presets");
            if (const auto wished = readings_.presets.draw(document_.shown(), document_.settings(),
                                                           readings_.study.calibration(), form_)) {
                document_.set_settings(*wished);
                gesture_item_ = form_.finished() ? 0 : ImGui::GetCurrentContext()->ActiveId;
            }
            form_.end();
            form_.begin("settings");
            form_.heading("By hand");
            if (const auto wished = settings_panel(document_.settings(), form_)) {
                document_.set_settings(*wished);
                gesture_item_ = form_.finished() ? 0 : ImGui::GetCurrentContext()->ActiveId;
            }
            form_.end();
            ImGui::EndChild();
            ImGui::EndTabItem();
        }
        end_tabs();
    }
    end_panel();
}

}  // namespace hanei
