#include "ui/panels/elided.h"
#include "ui/panels/icon.h"
#include "ui/panels/language.h"
#include "ui/panels/measure_tool.h"
#include "ui/panels/style.h"
#include "ui/panels/walk_tool.h"
#include "ui/panels/workbench.h"

#include <cmath>
#include <fmt/format.h>
#include <imgui_internal.h>

namespace hanei {
namespace {

/// As wide as a command's drawing, so that the words of all rows stand below each other.
std::string blank_of_icon() {
    return std::string(static_cast<std::size_t>(std::ceil(1.5F * icon_size() / ImGui::CalcTextSize(" ").x)), ' ');
}

/// The menus that are open on the way along the commands: one of the bar, and one within it.
class OpenMenus {
public:
    /// Whether the command's row is on the screen.
    bool reaches(const Command& entry, WidgetRegistry& widgets) {
        if (entry.menu != menu_) {
            close();
            menu_ = entry.menu;
            is_open_ = ImGui::BeginMenu(fmt::format("{}###{}", tr(menu_), menu_).c_str());
            widgets.note(fmt::format("menu.{}", menu_));
        }
        if (!is_open_) return false;
        if (entry.group == group_) {
            if (entry.starts_section && shows_row()) ImGui::Separator();
            return shows_row();
        }
        close_group();
        group_ = entry.group;
        if (entry.starts_section) ImGui::Separator();
        if (group_.empty()) return true;
        const std::string label = fmt::format("{}###{}", tr(group_), group_);
        group_is_open_ = ImGui::BeginMenuEx(label.c_str(), blank_of_icon().c_str());
        widgets.note(fmt::format("menu.{}.{}", menu_, group_));
        return group_is_open_;
    }
    void close() {
        close_group();
        if (is_open_) ImGui::EndMenu();
        is_open_ = false;
    }

private:
    bool shows_row() const { return group_.empty() || group_is_open_; }
    void close_group() {
        if (group_is_open_) ImGui::EndMenu();
        group_is_open_ = false;
        group_ = {};
    }

    std::string_view menu_, group_;
    bool is_open_ = false, group_is_open_ = false;
};

/// With the command's drawing before its words.
bool menu_item(const std::string& label, const Command& entry, bool ticked, bool can) {
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const float size = icon_size();
    const std::string blank = blank_of_icon();
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
        case CommandId::walk_through:
            return dynamic_cast<const WalkTool*>(viewport_.tool()) != nullptr;
        case CommandId::measure_distance:
            return dynamic_cast<const MeasureTool*>(viewport_.tool()) != nullptr;
        case CommandId::toggle_axes:
            return view.axes;
        case CommandId::toggle_scale_bar:
            return view.scale_bar;
        case CommandId::toggle_distances:
            return view.distances;
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
    OpenMenus open;
    for (const Command& entry : commands()) {
        if (entry.menu.empty() || !open.reaches(entry, widgets_)) continue;
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
    open.close();
    const std::string name = (document_.is_saved() ? "" : "•  ") + document_.title();
    const float room = ImGui::GetWindowWidth() - ImGui::GetCursorPosX() - 56.0F * style::scale();
    const std::string shown = elided(name, room, Elide::middle);
    ImGui::SameLine(ImGui::GetWindowWidth() - ImGui::CalcTextSize(shown.c_str()).x - 28.0F * style::scale());
    ImGui::TextColored(style::colour(style::quiet_text), "%s", shown.c_str());
    const char* const state = tr(document_.is_saved() ? "Saved" : "Has changes that were not saved");
    tooltip(shown.size() == name.size() ? std::string(state) : fmt::format("{}\n{}", document_.title(), state));
    ImGui::EndMainMenuBar();
}

}  // namespace hanei
