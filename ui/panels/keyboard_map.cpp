#include "ui/panels/keyboard_map.h"

#include "ui/panels/command.h"
#include "ui/panels/language.h"
#include "ui/panels/style.h"

#include <algorithm>
#include <array>
#include <fmt/format.h>
#include <imgui.h>
#include <numeric>

namespace hanei {
namespace {

// Pixels at scale 1.
constexpr float column_width = 400.0F;  // that two columns need each
constexpr float keys_width = 138.0F;
constexpr float row_gap = 3.0F, group_gap = 8.0F;

constexpr std::array mouse_map{
    std::pair{"Click", "Choose what is under the pointer"},
    std::pair{"Drag the chosen object", "Move it in the plan; by an arrow along that axis, by a ring turn it"},
    std::pair{"X, Y, Z while dragging", "Keep to that axis; again: free"},
    std::pair{"A figure while dragging", "How far it goes (0.6; 1.2 in x and y, degrees for turns); Enter ends it"},
    std::pair{"Ctrl while dragging", "Leave the raster and the lines, or keep to them"},
    std::pair{"Right click", "What can be done there"},
    std::pair{"Drag the room, right drag", "Turn the view"},
    std::pair{"Middle drag, Shift+drag", "Shift the view"},
    std::pair{"Wheel", "Closer to, or away from, what is under the pointer"},
    std::pair{"W A S D while walking", "Walk; drag to look, Shift is faster, Q and E lower and raise the eye"},
    std::pair{"Drag a figure", "Change it; click it to type"},
};

std::string keys_of(const Command& entry) {
    const std::string other = to_text(entry.other);
    const bool variant = entry.other.key == entry.chord.key;
    return to_text(entry.chord) + (other.empty() || variant ? "" : ", " + other);
}

float wrapped_height(std::string_view text, float width) {
    return ImGui::CalcTextSize(text.data(), text.data() + text.size(), false, width).y;
}

float height_of(const KeyGroup::Row& row, float what_width) {
    const float scale = style::scale();
    return std::max(wrapped_height(row.keys, (keys_width - 10.0F) * scale), wrapped_height(tr(row.what), what_width)) +
           row_gap * scale;
}

float height_of(const KeyGroup& group, float width) {
    const float scale = style::scale();
    float height = style::fonts().strong->FontSize + (row_gap + group_gap) * scale;
    for (const KeyGroup::Row& row : group.rows) height += height_of(row, width - keys_width * scale);
    return height;
}

/// `at` is its top left corner.
void draw(const KeyGroup& group, ImVec2 at, float width, WidgetRegistry& widgets) {
    const float scale = style::scale();
    const auto text_at = [&](float x, float y, std::string_view text, float room, ImU32 ink) {
        ImGui::SetCursorScreenPos({x, y});
        ImGui::PushTextWrapPos(x - ImGui::GetWindowPos().x + ImGui::GetScrollX() + room);
        ImGui::PushStyleColor(ImGuiCol_Text, ink);
        ImGui::TextUnformatted(text.data(), text.data() + text.size());
        ImGui::PopStyleColor();
        ImGui::PopTextWrapPos();
    };
    float y = at.y;
    ImGui::PushFont(style::fonts().strong);
    text_at(at.x, y, tr(group.title), width, style::text);
    ImGui::PopFont();
    widgets.note(fmt::format("keys.{}", group.title));
    y += style::fonts().strong->FontSize + row_gap * scale;
    for (const KeyGroup::Row& row : group.rows) {
        text_at(at.x, y, row.keys, (keys_width - 10.0F) * scale, style::accent);
        text_at(at.x + keys_width * scale, y, tr(row.what), width - keys_width * scale, style::text);
        y += height_of(row, width - keys_width * scale);
    }
}

}  // namespace

std::vector<KeyGroup> keyboard_map() {
    std::vector<KeyGroup> groups;
    KeyGroup others{"Without a menu", {}};
    for (const Command& entry : commands()) {
        if (entry.chord.key == Key::none) continue;
        if (entry.menu.empty()) {
            others.rows.push_back({keys_of(entry), entry.help});
            continue;
        }
        const auto same = [&](const KeyGroup& group) { return group.title == entry.menu; };
        auto group = std::find_if(groups.begin(), groups.end(), same);
        if (group == groups.end()) group = groups.insert(groups.end(), {entry.menu, {}});
        group->rows.push_back({keys_of(entry), entry.help});
    }
    if (!others.rows.empty()) groups.push_back(std::move(others));
    KeyGroup mouse{"Mouse", {}};
    for (const auto& [keys, what] : mouse_map) mouse.rows.push_back({tr(keys), what});
    groups.push_back(std::move(mouse));
    return groups;
}

std::size_t balanced(std::span<const float> heights) {
    const float all = std::accumulate(heights.begin(), heights.end(), 0.0F);
    std::size_t best = heights.size();
    float least = all, first = 0.0F;
    for (std::size_t k = 0; k < heights.size(); ++k) {
        first += heights[k];
        const float higher = std::max(first, all - first);
        if (higher >= least) continue;
        least = higher;
        best = k + 1;
    }
    return best;
}

void draw_keyboard_map(float greatest_height, WidgetRegistry& widgets) {
    const float scale = style::scale(), gap = 28.0F * scale;
    const std::vector<KeyGroup> groups = keyboard_map();
    const float room = ImGui::GetContentRegionAvail().x - ImGui::GetStyle().ScrollbarSize;
    const bool two = room >= 2.0F * column_width * scale + gap;
    const float width = two ? 0.5F * (room - gap) : room;
    ImGui::PushFont(style::fonts().small);
    std::vector<float> heights;
    for (const KeyGroup& group : groups) heights.push_back(height_of(group, width));
    const std::size_t parting = two ? balanced(heights) : groups.size();
    const float left = std::accumulate(heights.begin(), heights.begin() + static_cast<std::ptrdiff_t>(parting), 0.0F);
    const float right = std::accumulate(heights.begin() + static_cast<std::ptrdiff_t>(parting), heights.end(), 0.0F);
    const float whole = std::max(left, right);
    ImGui::BeginChild("keys", {0.0F, std::min(whole, greatest_height)});
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    ImVec2 at = corner;
    for (std::size_t k = 0; k < groups.size(); ++k) {
        if (k == parting) at = {corner.x + width + gap, corner.y};
        draw(groups[k], at, width, widgets);
        at.y += heights[k];
    }
    ImGui::SetCursorScreenPos(corner);
    ImGui::Dummy({room, whole});
    ImGui::EndChild();
    ImGui::PopFont();
}

}  // namespace hanei
