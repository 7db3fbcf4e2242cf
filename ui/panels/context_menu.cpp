#include "ui/panels/context_menu.h"

#include "ui/panels/form.h"
#include "ui/panels/language.h"

#include <fmt/format.h>
#include <imgui.h>

namespace hanei {
namespace {

using enum CommandId;

constexpr CommandId line = quit;  // stands for a line between two sections

}  // namespace

std::vector<CommandId> context_commands(ObjectKind kind) {
    switch (kind) {
        case ObjectKind::none:
        case ObjectKind::room:
            return {paste,
                    select_all,
                    box_select,
                    line,
                    add_panel_luminaire,
                    add_line_luminaire,
                    add_point_luminaire,
                    add_luminaire_file,
                    add_furniture,
                    add_door,
                    add_window,
                    add_grid,
                    add_calculation_point,
                    line,
                    show_overview,
                    show_plan,
                    command_search};
        case ObjectKind::luminaire:
        case ObjectKind::arrangement:
            return {cut,
                    copy,
                    paste,
                    duplicate,
                    remove,
                    line,
                    look_at_selection,
                    turn_object,
                    turn_intensities,
                    light_aim,
                    light_field,
                    line,
                    group_objects,
                    ungroup_objects,
                    light_group,
                    line,
                    select_same,
                    toggle_shadow_outlines,
                    toggle_body,
                    command_search};
        case ObjectKind::furniture:
        case ObjectKind::object_group:
            return {cut,         copy,         paste,        duplicate,     remove, line,          look_at_selection,
                    turn_object, put_on_floor, push_to_wall, array_copies,  line,   group_objects, ungroup_objects,
                    line,        select_same,  select_all,   command_search};
        default:
            return {cut,         copy, paste,       duplicate,  remove,        line, look_at_selection,
                    turn_object, line, select_same, select_all, command_search};
    }
}

void ContextMenu::open(ObjectKind kind) {
    kind_ = kind;
    opening_ = true;
}

std::optional<CommandId> ContextMenu::draw(const std::function<bool(CommandId)>& can, WidgetRegistry& widgets) {
    if (opening_) ImGui::OpenPopup("###context");
    opening_ = false;
    if (!ImGui::BeginPopup("###context")) return std::nullopt;
    std::optional<CommandId> wished;
    bool line_due = false, any = false;
    for (const CommandId id : context_commands(kind_)) {
        if (id == line) {
            line_due = any;
            continue;
        }
        if (!can(id)) continue;
        if (line_due) ImGui::Separator();
        line_due = false;
        any = true;
        const Command& entry = command(id);
        const std::string label = fmt::format("{}##{}", tr(entry.label), entry.name);
        if (ImGui::MenuItem(label.c_str(), to_text(entry.chord).c_str())) wished = id;
        widgets.note("context." + std::string(entry.name));
        tooltip(std::string(entry.help));
    }
    ImGui::EndPopup();
    return wished;
}

}  // namespace hanei
