#include "ui/panels/language.h"
#include "ui/panels/style.h"
#include "ui/panels/workbench.h"

#include <fmt/format.h>
#include <imgui.h>

namespace hanei {

void Workbench::menu_bar() {
    if (!ImGui::BeginMainMenuBar()) return;
    std::string_view menu;
    bool open = false;
    for (const Command& entry : commands()) {
        if (entry.menu.empty()) continue;
        if (entry.menu != menu) {
            if (open) ImGui::EndMenu();
            menu = entry.menu;
            open = ImGui::BeginMenu(fmt::format("{}###{}", tr(menu), menu).c_str());
            widgets_.note("menu." + std::string(menu));
        }
        if (!open) continue;
        if (entry.starts_section) ImGui::Separator();
        std::string label(tr(entry.label));
        style::needs(label);
        if (entry.id == CommandId::undo && can(entry.id)) label += " " + document_.history().undo_name();
        if (entry.id == CommandId::redo && can(entry.id)) label += " " + document_.history().redo_name();
        const bool ticked =
            (entry.id == CommandId::toggle_snap && snaps_) ||
            (entry.id == CommandId::four_up && viewport_.state.panes.shows_parts()) ||
            (entry.id == CommandId::split_view && viewport_.state.panes.layout() == PaneLayout::split) ||
            (entry.id == CommandId::four_views && viewport_.state.panes.layout() == PaneLayout::four) ||
            (entry.id == CommandId::toggle_ceiling && viewport_.state.camera.left_out.ceiling) ||
            (entry.id == CommandId::toggle_section_plane && viewport_.state.camera.left_out.cut) ||
            (entry.id == CommandId::toggle_orthographic && viewport_.state.camera.orthographic) ||
            (entry.id == CommandId::toggle_shadow_classes && viewport_.state.options.shadow_classes) ||
            (entry.id == CommandId::toggle_shadow_outlines && viewport_.state.options.shadow_outlines) ||
            (entry.id == CommandId::show_a && readings_.snapshots.show == Snapshots::Show::a) ||
            (entry.id == CommandId::show_difference && readings_.snapshots.show == Snapshots::Show::difference) ||
            (entry.id == CommandId::toggle_values && viewport_.state.options.values) ||
            (entry.id == CommandId::toggle_recording && recording_.is_on()) ||
            (entry.id == CommandId::toggle_isolux && viewport_.state.options.isolux) ||
            (entry.id == CommandId::switch_theme && preferences_.theme == Theme::light) ||
            (entry.id == CommandId::switch_language && preferences_.language == Language::japanese) ||
            (entry.id == CommandId::toggle_photo && viewport_.state.options.scale == Scale::photo);
        const bool wished = ImGui::MenuItem((label + "###" + std::string(entry.name)).c_str(),
                                            to_text(entry.chord).c_str(), ticked, can(entry.id));
        widgets_.note(std::string(entry.name));
        tooltip(std::string(entry.help));
        if (wished) carry_out(entry.id);
        if (entry.id != CommandId::open) continue;
        if (const auto recent = recent_menu_.draw(preferences_.recent, widgets_))
            guarded([this, file = *recent] { load(file); });
    }
    if (open) ImGui::EndMenu();
    const std::string name = (document_.is_saved() ? "" : "•  ") + document_.title();
    const float width = ImGui::CalcTextSize(name.c_str()).x;
    ImGui::SameLine(ImGui::GetWindowWidth() - width - 28.0F * style::scale());
    ImGui::TextColored(style::colour(style::quiet_text), "%s", name.c_str());
    tooltip(document_.is_saved() ? "Saved" : "Has changes that were not saved");
    ImGui::EndMainMenuBar();
}

}  // namespace hanei
