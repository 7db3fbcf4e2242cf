#include "ui/panels/panel_frame.h"

#include "ui/panels/elided.h"
#include "ui/panels/language.h"
#include "ui/panels/style.h"

#include <algorithm>
#include <fmt/format.h>
#include <imgui.h>

namespace hanei {

void begin_panel(const char* name, const ScreenRect& area, bool padded) {
    ImGui::SetNextWindowPos({area.left, area.top});
    ImGui::SetNextWindowSize({std::max(1.0F, area.right - area.left), std::max(1.0F, area.bottom - area.top)});
    if (!padded) ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {0.0F, 0.0F});
    ImGui::PushStyleVar(ImGuiStyleVar_WindowMinSize, {1.0F, 1.0F});
    ImGui::Begin(name, nullptr,
                 ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings |
                     ImGuiWindowFlags_NoBringToFrontOnFocus | ImGuiWindowFlags_NoScrollWithMouse);
    ImGui::PopStyleVar(padded ? 1 : 2);
}

void end_panel() { ImGui::End(); }

void movable_edge(Edge edge, const ScreenRect& area, float& size, float low, float high) {
    const float grip = 5.0F * style::scale();
    const ImVec2 keep = ImGui::GetCursorScreenPos();
    const bool level = edge == Edge::top;
    ImGui::PushClipRect({area.left, area.top}, {area.right, area.bottom}, false);  // it lies in the padding
    ImGui::SetCursorScreenPos({edge == Edge::right ? area.right - grip : area.left, area.top});
    ImGui::InvisibleButton("edge", {level ? area.right - area.left : grip, level ? grip : area.bottom - area.top});
    ImGui::SetItemAllowOverlap();
    if (ImGui::IsItemHovered() || ImGui::IsItemActive()) {
        ImGui::SetMouseCursor(level ? ImGuiMouseCursor_ResizeNS : ImGuiMouseCursor_ResizeEW);
    }
    if (ImGui::IsItemActive()) {
        const ImVec2 by = ImGui::GetIO().MouseDelta;
        const float grows = edge == Edge::right ? by.x : edge == Edge::left ? -by.x : -by.y;
        size = std::clamp(size + grows / style::scale(), low, high);
    }
    ImGui::PopClipRect();
    ImGui::SetCursorScreenPos(keep);
}

void begin_wide(const char* name, float least_width) {
    const float least = least_width * style::scale();
    const bool rolls = ImGui::GetContentRegionAvail().x < least;
    if (rolls) ImGui::SetNextWindowContentSize({least, 0.0F});
    ImGui::BeginChild(name, {0.0F, 0.0F}, false,
                      rolls ? ImGuiWindowFlags_HorizontalScrollbar : ImGuiWindowFlags_NoScrollbar);
}

void end_wide() { ImGui::EndChild(); }

void headline(std::string_view text, std::string_view quiet) {
    const float room = ImGui::GetContentRegionAvail().x, space = ImGui::GetStyle().ItemSpacing.x;
    const float wanted =
        quiet.empty() ? 0.0F : ImGui::CalcTextSize(quiet.data(), quiet.data() + quiet.size()).x + space;
    constexpr float greatest_share = 0.45F;  // of the line, of the quiet word where both have too little room
    ImGui::PushFont(style::fonts().strong);
    elided_text(text, std::max(1.0F, room - std::min(wanted, greatest_share * room)), Elide::middle);
    ImGui::PopFont();
    if (!quiet.empty()) {
        ImGui::SameLine();
        ImGui::PushStyleColor(ImGuiCol_Text, style::quiet_text);
        elided_text(quiet);
        ImGui::PopStyleColor();
    }
    ImGui::Dummy({0.0F, 2.0F * style::scale()});
}

bool begin_tab(const char* label, WidgetRegistry& widgets, std::size_t count, bool to_front) {
    const std::string shown =
        count == 0 ? fmt::format("{}###{}", tr(label), label) : fmt::format("{}  {}###{}", tr(label), count, label);
    const bool open =
        ImGui::BeginTabItem(shown.c_str(), nullptr, to_front ? ImGuiTabItemFlags_SetSelected : ImGuiTabItemFlags_None);
    widgets.note(fmt::format("tab.{}", label));
    return open;
}

}  // namespace hanei
