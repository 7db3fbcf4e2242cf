#include "ui/panels/icon.h"
#include "ui/panels/language.h"
#include "ui/panels/style.h"
#include "ui/panels/workbench.h"

#include <cmath>
#include <fmt/format.h>
#include <imgui_internal.h>

namespace hanei {
namespace {

/// With the command's drawing before its words; the words of all stand below each other.
bool menu_item(const std::string& label, const Command& entry, bool ticked, bool can) {
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const float size = icon_size();
    const std::string blank(static_cast<std::size_t>(std::ceil(1.5F * size / ImGui::CalcTextSize(" ").x)), ' ');
    const bool wished = ImGui::MenuItemEx((label + "###" + std::string(entry.name)).c_str(), blank.c_str(),
                                          to_text(entry.chord).c_str(), ticked, can);
    const float below = 0.5F * (ImGui::GetTextLineHeight() - size);
    draw_icon(*ImGui::GetWindowDrawList(), icon_of(entry.name), {at.x, at.y + below}, size,
              style::faded(style::quiet_text, can ? 1.0F : 0.5F));
    return wished;
}

}  // namespace

bool Workbench::is_on(CommandId id) const {
    const ViewState& view = viewport_.state;
    switch (id) {
        case CommandId::toggle_snap:
            return snap_.on;
        case CommandId::four_up:
            return view.panes.shows_parts();
        case CommandId::split_view:
            return view.panes.layout() == PaneLayout::split;
        case CommandId::four_views:
            return view.panes.layout() == PaneLayout::four;
        case CommandId::toggle_ceiling:
            return view.camera.left_out.ceiling;
        case CommandId::toggle_section_plane:
            return view.camera.left_out.cut.has_value();
        case CommandId::toggle_orthographic:
            return view.camera.orthographic;
        case CommandId::toggle_shadow_classes:
            return view.options.shadow_classes;
        case CommandId::toggle_shadow_outlines:
            return view.options.shadow_outlines;
        case CommandId::show_a:
            return readings_.snapshots.show == Snapshots::Show::a;
        case CommandId::show_difference:
            return readings_.snapshots.show == Snapshots::Show::difference;
        case CommandId::toggle_values:
            return view.options.values;
        case CommandId::toggle_recording:
            return recording_.is_on();
        case CommandId::toggle_isolux:
            return view.options.isolux;
        case CommandId::switch_theme:
            return preferences_.theme == Theme::light;
        case CommandId::switch_language:
            return preferences_.language == Language::japanese;
        case CommandId::toggle_photo:
            return view.options.scale == Scale::photo;
        default:
            return false;
    }
}

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
        if (entry.id == CommandId::undo && can(entry.id)) label += ": " + phrase(document_.history().undo_name());
        if (entry.id == CommandId::redo && can(entry.id)) label += ": " + phrase(document_.history().redo_name());
        const bool wished = menu_item(label, entry, is_on(entry.id), can(entry.id));
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
