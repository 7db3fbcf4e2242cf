#include "ui/panels/tool_bar.h"

#include "ui/panels/form.h"
#include "ui/panels/icon.h"
#include "ui/panels/language.h"
#include "ui/panels/panel_frame.h"
#include "ui/panels/style.h"
#include "ui/panels/workbench.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>

namespace hanei {
namespace {

using namespace std::string_view_literals;

constexpr std::array entries{
    "edit.undo"sv,
    "edit.redo"sv,
    ""sv,
    "view.overview"sv,
    "view.plan"sv,
    "view.look"sv,
    "view.section"sv,
    ""sv,
    "room.draw"sv,
    "add.panel"sv,
    "add.file"sv,
    "add.furniture"sv,
    "add.grid"sv,
    "light.aim"sv,
    ""sv,
    "edit.box_select"sv,
    "results.pin"sv,
    "results.profile"sv,
    "results.why"sv,
    "results.values"sv,
};
constexpr float margin = 5.0F;
constexpr float gap = 9.0F;

const Command* command_named(std::string_view name) {
    const auto found =
        std::find_if(commands().begin(), commands().end(), [&](const Command& entry) { return entry.name == name; });
    return found == commands().end() ? nullptr : &*found;
}

std::string help_of(const Command& entry) {
    const std::string chord = to_text(entry.chord);
    return fmt::format("{}{}\n{}", tr(entry.label), chord.empty() ? "" : "  " + chord, tr(entry.help));
}

void separator() {
    const float scale = style::scale();
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const float y = std::round(at.y + 0.5F * gap * scale);
    const float inset = 4.0F * scale;
    ImGui::GetWindowDrawList()->AddLine({at.x + inset, y}, {at.x + ImGui::GetFrameHeight() - inset, y}, style::line,
                                        style::hairline());
    ImGui::Dummy({1.0F, gap * scale});
}

/// How many of them stand in this height; where not all do, one place is kept for a button with the rest.
std::size_t shown_entries(float height) {
    const float space = ImGui::GetStyle().ItemSpacing.y, button = ImGui::GetFrameHeight() + space;
    const auto height_of = [&](std::string_view name) { return name.empty() ? gap * style::scale() + space : button; };
    float all = 0.0F;
    for (const std::string_view name : entries) all += height_of(name);
    if (all - space <= height) return entries.size();
    float used = button - space;
    for (std::size_t k = 0; k < entries.size(); ++k) {
        used += height_of(entries[k]);
        if (used > height) return k > 0 && entries[k - 1].empty() ? k - 1 : k;
    }
    return entries.size();
}

}  // namespace

float tool_bar_width() { return ImGui::GetFrameHeight() + 2.0F * std::round(margin * style::scale()); }

std::span<const std::string_view> tool_bar_entries() { return entries; }

void Workbench::tool_bar(const ScreenRect& area) {
    const float side = std::round(margin * style::scale());
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {side, side});
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {0.0F, std::round(2.0F * style::scale())});
    begin_panel("##tools", area);
    const std::size_t shown = shown_entries(area.bottom - side - ImGui::GetCursorScreenPos().y);
    for (const std::string_view name : tool_bar_entries().first(shown)) {
        const Command* const entry = command_named(name);
        if (entry == nullptr) {
            separator();
            continue;
        }
        const bool allowed = can(entry->id);
        ImGui::BeginDisabled(!allowed);
        const std::string widget = "tool." + std::string(name);
        if (icon_button(widget.c_str(), icon_of(name), help_of(*entry), is_on(entry->id), widgets_))
            carry_out(entry->id);
        ImGui::EndDisabled();
    }
    if (shown < entries.size()) {
        if (ImGui::Button("…", {ImGui::GetFrameHeight(), 0.0F})) ImGui::OpenPopup("more_tools");
        widgets_.note("tool.more");
        tooltip("The tools that have no room here");
    }
    ImGui::PopStyleVar(2);
    if (ImGui::BeginPopup("more_tools")) {
        for (const std::string_view name : tool_bar_entries().subspan(shown)) {
            const Command* const entry = command_named(name);
            if (entry == nullptr) continue;
            const std::string label = fmt::format("{}###{}", tr(entry->label), entry->name);
            if (ImGui::MenuItem(label.c_str(), to_text(entry->chord).c_str(), is_on(entry->id), can(entry->id)))
                carry_out(entry->id);
            widgets_.note("tool." + std::string(name));
            tooltip(std::string(entry->help));
        }
        ImGui::EndPopup();
    }
    end_panel();
}

}  // namespace hanei
