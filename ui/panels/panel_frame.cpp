#include "ui/panels/panel_frame.h"

#include "ui/panels/elided.h"
#include "ui/panels/language.h"
#include "ui/panels/style.h"

#include <algorithm>
#include <fmt/format.h>
#include <imgui_internal.h>

namespace hanei {
namespace {

constexpr float tight_padding = 4.0F, tight_gap = 2.0F;  // of tabs, at scale 1

enum class Tabs { loose, tight, rolled };
Tabs tabs = Tabs::loose;  ///< of the open bar

}  // namespace

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

bool begin_tabs(const char* name) {
    const ImGuiStyle& look = ImGui::GetStyle();
    const float room = ImGui::GetContentRegionAvail().x;
    ImGuiStorage& kept = *ImGui::GetStateStorage();
    const ImGuiID id = ImGui::GetID(name);
    tabs = static_cast<Tabs>(kept.GetInt(id));
    const bool open = ImGui::BeginTabBar(
        name, ImGuiTabBarFlags_FittingPolicyScroll |
                  (tabs == Tabs::rolled ? ImGuiTabBarFlags_TabListPopupButton : ImGuiTabBarFlags_None));
    if (!open) return false;
    const ImGuiTabBar& bar = *ImGui::GetCurrentContext()->CurrentTabBar;  // its width is that of the last frame
    const auto count = static_cast<float>(bar.Tabs.Size);
    const float saved = count * 2.0F * (look.FramePadding.x - tight_padding * style::scale()) +
                        (count - 1.0F) * (look.ItemInnerSpacing.x - tight_gap * style::scale());
    const float loose = bar.WidthAllTabsIdeal + (tabs == Tabs::loose ? 0.0F : saved);
    kept.SetInt(id, static_cast<int>(loose <= room ? Tabs::loose : loose - saved <= room ? Tabs::tight : Tabs::rolled));
    return true;
}

void end_tabs() { ImGui::EndTabBar(); }

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
    const ImGuiStyle& look = ImGui::GetStyle();
    const bool loose = tabs == Tabs::loose;
    const float padding = loose ? look.FramePadding.x : tight_padding * style::scale();
    const float gap = loose ? look.ItemInnerSpacing.x : tight_gap * style::scale();
    ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, {padding, look.FramePadding.y});
    ImGui::PushStyleVar(ImGuiStyleVar_ItemInnerSpacing, {gap, look.ItemInnerSpacing.y});
    const bool open =
        ImGui::BeginTabItem(shown.c_str(), nullptr, to_front ? ImGuiTabItemFlags_SetSelected : ImGuiTabItemFlags_None);
    ImGui::PopStyleVar(2);
    widgets.note(fmt::format("tab.{}", label));
    return open;
}

}  // namespace hanei
