#include "ui/panels/elided.h"
#include "ui/panels/form.h"
#include "ui/panels/illuminance_text.h"
#include "ui/panels/language.h"
#include "ui/panels/legend_scale.h"
#include "ui/panels/style.h"
#include "ui/panels/view_bar.h"
#include "ui/view/colour_scale.h"
#include "ui/view/isolux_labels.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <imgui.h>

namespace hanei {
namespace {

constexpr float bar_width = 16.0F;
constexpr float card_width = 88.0F;
constexpr float greatest_height = 356.0F;
constexpr float cap_height = 9.0F;
constexpr float least_low_height = 72.0F;

ImU32 packed(const glm::vec3& colour) { return ImGui::ColorConvertFloat4ToU32({colour.r, colour.g, colour.b, 1.0F}); }

void draw_bar(ImDrawList& list, const ViewOptions& options, ImVec2 low, ImVec2 high) {
    const int rows = static_cast<int>(high.y - low.y);
    for (int k = 0; k < rows; ++k) {
        const double position = 1.0 - (k + 0.5) / rows;
        const float y = low.y + static_cast<float>(k);
        list.AddRectFilled({low.x, y}, {high.x, y + 1.0F}, packed(colour_of(lux_at(position, options), options)));
    }
}

/// What lies beyond an end, hatched as in the picture.
void draw_cap(ImDrawList& list, const ViewOptions& options, bool above, ImVec2 low, ImVec2 high) {
    list.AddRectFilled(low, high, packed(above ? colour_above : colour_below));
    if (options.marks_clipped) {
        const ImU32 stripe = packed(above ? stripe_above : stripe_below);
        const float step = 5.0F * style::scale(), height = high.y - low.y;
        list.PushClipRect(low, high, true);
        for (float x = low.x - height; x < high.x; x += step) {
            list.AddLine({x, low.y}, {x + height, high.y}, stripe, 1.4F * style::scale());
            if (above) list.AddLine({x, high.y}, {x + height, low.y}, stripe, 1.4F * style::scale());
        }
        list.PopClipRect();
    }
    list.AddRect(low, high, IM_COL32(255, 255, 255, 70));
}

void draw_ticks(ImDrawList& list, const ViewOptions& options, ImVec2 low, ImVec2 high) {
    const style::Fonts& fonts = style::fonts();
    const float line = fonts.small->FontSize;
    float last = 1e9F;
    for (const double lux : scale_steps(options)) {
        const float y = high.y - static_cast<float>(legend_position(lux, options)) * (high.y - low.y);
        if (y < low.y - 0.5F || y > high.y + 0.5F || last - y < line) continue;
        last = y;
        list.AddLine({high.x + 2.0F, y}, {high.x + 6.0F, y}, style::quiet_text);
        const std::string text = lux_text(lux, options.unit);
        list.AddText(fonts.small, line, {high.x + 10.0F * style::scale(), y - 0.5F * line}, style::text, text.c_str());
    }
}

/// A bound of the range, to drag or type; keeps the two apart by a hundredth.
void bound_field(const char* name, double& lux, double low, double high, WidgetRegistry& widgets, const char* help) {
    const double unit = lux_in(illuminance_unit());
    double value = lux / unit;
    low /= unit;
    high /= unit;
    ImGui::SetNextItemWidth((card_width - 16.0F) * style::scale());
    const char* format = value < 10.0 ? "%.1f" : "%.0f";
    const bool changed =
        ImGui::DragScalar(name, ImGuiDataType_Double, &value, static_cast<float>(std::max(0.02, 0.005 * value)), &low,
                          &high, format, ImGuiSliderFlags_AlwaysClamp);
    widgets.note(std::string("legend.") + (name + 2));
    tooltip(tr(help));
    if (changed && std::isfinite(value)) lux = value * unit;
}

/// An end of the bar, to drag: up for more.
void end_grip(const char* name, bool top, ViewOptions& options, const ImVec2& low, const ImVec2& high, float length,
              WidgetRegistry& widgets) {
    ImGui::SetCursorScreenPos(low);
    ImGui::InvisibleButton(name, {high.x - low.x, high.y - low.y});
    widgets.note(std::string("legend.") + name);
    if (ImGui::IsItemHovered() || ImGui::IsItemActive()) ImGui::SetMouseCursor(ImGuiMouseCursor_ResizeNS);
    if (!ImGui::IsItemActive())
        tooltip(tr(top ? "Drag the upper end of the scale" : "Drag the lower end of the scale"));
    ImGuiStorage& kept = *ImGui::GetStateStorage();
    const ImGuiID from_low = ImGui::GetID("grip.low"), from_high = ImGui::GetID("grip.high");
    if (ImGui::IsItemActivated()) {
        kept.SetFloat(from_low, static_cast<float>(options.range.low));
        kept.SetFloat(from_high, static_cast<float>(options.range.high));
    }
    const float by = ImGui::GetMouseDragDelta(ImGuiMouseButton_Left, 0.0F).y;
    if (!ImGui::IsItemActive() || by == 0.0F) return;
    ViewOptions begun = options;
    begun.range = {static_cast<double>(kept.GetFloat(from_low)), static_cast<double>(kept.GetFloat(from_high))};
    options.range = range_dragged(begun, top, static_cast<double>(-by / length));
}

/// Without fields, where the view is too low for them: the ends are named at the bar.
void low_legend(const ViewOptions& options, const ScreenRect& view, WidgetRegistry& widgets) {
    const float scale = style::scale(), line = style::fonts().small->FontSize;
    const float height = view.bottom - view.top - 12.0F * scale;
    if (height < least_low_height * scale) return;
    const ImVec2 low{view.right - (card_width + 6.0F) * scale, view.top + 6.0F * scale};
    const ImVec2 high{view.right - 6.0F * scale, low.y + height};
    ImDrawList& list = *ImGui::GetWindowDrawList();
    list.AddRectFilled(low, high, style::card, 6.0F * scale);
    const float left = low.x + 8.0F * scale;
    const std::string heading =
        elided(fmt::format("{}  {}", tr("Illuminance"), illuminance_unit_name()), (card_width - 16.0F) * scale);
    list.AddText(style::fonts().small, line, {left, low.y + 5.0F * scale}, style::quiet_text, heading.c_str());
    const ImVec2 bar_low{left + 2.0F * scale, low.y + 1.5F * line + 10.0F * scale};
    const ImVec2 bar_high{bar_low.x + bar_width * scale, high.y - 0.5F * line - 6.0F * scale};
    draw_bar(list, options, bar_low, bar_high);
    draw_ticks(list, options, bar_low, bar_high);
    widgets.note("legend", {low.x, low.y, high.x, high.y});
}

}  // namespace

float legend_margin() { return (card_width + 24.0F) * style::scale(); }

void legend(ViewState& state, bool of_project, const ScreenRect& view, WidgetRegistry& widgets) {
    if (state.options.scale == Scale::photo) return;
    const float scale = style::scale();
    const float field = ImGui::GetFrameHeight();
    const float title = style::fonts().small->FontSize + 6.0F * scale;
    const float height = std::min(greatest_height * scale, view.bottom - view.top - 24.0F * scale);
    if (height < 190.0F * scale) return low_legend(state.options, view, widgets);
    const ImVec2 card_low{view.right - (card_width + 12.0F) * scale, view.top + 12.0F * scale};
    const ImVec2 card_high{view.right - 12.0F * scale, card_low.y + height};
    ImDrawList& list = *ImGui::GetWindowDrawList();
    list.AddRectFilled(card_low, card_high, style::card, 6.0F * scale);
    const float left = card_low.x + 8.0F * scale;
    const std::string heading = fmt::format("{}  {}", tr("Illuminance"), illuminance_unit_name());
    list.AddText(style::fonts().small, style::fonts().small->FontSize, {left, card_low.y + 7.0F * scale},
                 style::quiet_text, heading.c_str());
    const ImVec2 keep = ImGui::GetCursorScreenPos();
    LuxRange& range = state.options.range;
    ImGui::SetCursorScreenPos({left, card_low.y + title + 6.0F * scale});
    bound_field("##high", range.high, range.low * 1.01 + 0.01, 1e6, widgets,
                "Greatest value of the scale: drag, or click and type");
    const float steps_top = card_high.y - field - 7.0F * scale;
    const float low_top = steps_top - field - 4.0F * scale;
    ImGui::SetCursorScreenPos({left, low_top});
    bound_field("##low", range.low, 0.1, range.high / 1.01, widgets,
                "Least value of the scale: drag, or click and type");
    ImGui::SetCursorScreenPos({left, steps_top});
    legend_menu(state, of_project, (card_width - 16.0F) * scale, widgets);

    const float cap = cap_height * scale;
    const ImVec2 bar_low{left + 2.0F * scale, card_low.y + title + field + cap + 16.0F * scale};
    const ImVec2 bar_high{bar_low.x + bar_width * scale, low_top - cap - 10.0F * scale};
    const float length = bar_high.y - bar_low.y;
    const ImVec2 top_cap{bar_low.x, bar_low.y - cap - 2.0F}, bottom_cap{bar_high.x, bar_high.y + cap + 2.0F};
    end_grip("top", true, state.options, top_cap, {bar_high.x, bar_low.y}, length, widgets);
    end_grip("bottom", false, state.options, {bar_low.x, bar_high.y}, bottom_cap, length, widgets);
    ImGui::SetCursorScreenPos(card_low);
    ImGui::InvisibleButton("card", {card_high.x - card_low.x, card_high.y - card_low.y});  // the view ends here
    ImGui::SetCursorScreenPos(keep);
    draw_bar(list, state.options, bar_low, bar_high);
    draw_cap(list, state.options, true, top_cap, {bar_high.x, bar_low.y - 2.0F});
    draw_cap(list, state.options, false, {bar_low.x, bar_high.y + 2.0F}, bottom_cap);
    draw_ticks(list, state.options, bar_low, bar_high);
    widgets.note("legend", {card_low.x, card_low.y, card_high.x, card_high.y});
}

}  // namespace hanei
