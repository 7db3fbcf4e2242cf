#include "ui/panels/form.h"
#include "ui/panels/style.h"
#include "ui/panels/view_bar.h"
#include "ui/view/colour_scale.h"
#include "ui/view/isolux_labels.h"

#include <algorithm>
#include <cmath>
#include <imgui.h>

namespace hanei {
namespace {

constexpr float bar_width = 16.0F;
constexpr float card_width = 88.0F;
constexpr float greatest_height = 330.0F;

std::vector<double> ticks_of(const ViewOptions& options) {
    if (options.steps != ColourSteps::linear) return standard_steps(options.range);
    const double span = options.range.high - options.range.low;
    const double decade = std::pow(10.0, std::floor(std::log10(span / 5.0)));
    const double step = span / decade > 25.0 ? 5.0 * decade : span / decade > 12.0 ? 2.0 * decade : decade;
    std::vector<double> ticks;
    for (double k = std::ceil(options.range.low / step); k * step <= options.range.high; k += 1.0)
        ticks.push_back(k * step);
    return ticks;
}

void draw_bar(ImDrawList& list, const ViewOptions& options, ImVec2 low, ImVec2 high) {
    const int rows = static_cast<int>(high.y - low.y);
    for (int k = 0; k < rows; ++k) {
        const double position = 1.0 - (k + 0.5) / rows;
        const glm::vec3 colour = colour_of(lux_at(position, options), options);
        const float y = low.y + static_cast<float>(k);
        list.AddRectFilled({low.x, y}, {high.x, y + 1.0F},
                           ImGui::ColorConvertFloat4ToU32({colour.r, colour.g, colour.b, 1.0F}));
    }
}

void draw_ticks(ImDrawList& list, const ViewOptions& options, ImVec2 low, ImVec2 high) {
    const style::Fonts& fonts = style::fonts();
    const float line = fonts.small->FontSize;
    float last = 1e9F;
    for (const double lux : ticks_of(options)) {
        const float y = high.y - static_cast<float>(legend_position(lux, options)) * (high.y - low.y);
        if (y < low.y - 0.5F || y > high.y + 0.5F || last - y < line) continue;
        last = y;
        list.AddLine({high.x + 2.0F, y}, {high.x + 6.0F, y}, style::quiet_text);
        const std::string text = lux_text(lux);
        list.AddText(fonts.small, line, {high.x + 10.0F * style::scale(), y - 0.5F * line}, style::text, text.c_str());
    }
}

/// A bound of the range, to drag or type; keeps the two apart by a hundredth.
void bound_field(const char* name, double& value, double low, double high, WidgetRegistry& widgets, const char* help) {
    ImGui::SetNextItemWidth((card_width - 16.0F) * style::scale());
    const char* format = value < 10.0 ? "%.1f" : "%.0f";
    ImGui::DragScalar(name, ImGuiDataType_Double, &value, static_cast<float>(std::max(0.02, 0.005 * value)), &low,
                      &high, format, ImGuiSliderFlags_AlwaysClamp);
    widgets.note(std::string("legend.") + (name + 2));
    tooltip(help);
}

}  // namespace

float legend_margin() { return (card_width + 24.0F) * style::scale(); }

void legend(ViewState& state, const ScreenRect& view, WidgetRegistry& widgets) {
    if (state.options.scale == Scale::photo) return;
    const float scale = style::scale();
    const float field = ImGui::GetFrameHeight();
    const float title = style::fonts().small->FontSize + 6.0F * scale;
    const float height = std::min(greatest_height * scale, view.bottom - view.top - 24.0F * scale);
    if (height < 160.0F * scale) return;
    const ImVec2 card_low{view.right - (card_width + 12.0F) * scale, view.top + 12.0F * scale};
    const ImVec2 card_high{view.right - 12.0F * scale, card_low.y + height};
    ImDrawList& list = *ImGui::GetWindowDrawList();
    list.AddRectFilled(card_low, card_high, style::card, 6.0F * scale);
    const float left = card_low.x + 8.0F * scale;
    list.AddText(style::fonts().small, style::fonts().small->FontSize, {left, card_low.y + 7.0F * scale},
                 style::quiet_text, "Illuminance  lx");
    const ImVec2 keep = ImGui::GetCursorScreenPos();
    LuxRange& range = state.options.range;
    ImGui::SetCursorScreenPos({left, card_low.y + title + 6.0F * scale});
    bound_field("##high", range.high, range.low * 1.01 + 0.01, 1e6, widgets,
                "Greatest value of the scale: drag, or click and type");
    ImGui::SetCursorScreenPos({left, card_high.y - field - 7.0F * scale});
    bound_field("##low", range.low, 0.1, range.high / 1.01, widgets,
                "Least value of the scale: drag, or click and type");
    ImGui::SetCursorScreenPos(card_low);
    ImGui::InvisibleButton("card", {card_high.x - card_low.x, card_high.y - card_low.y});  // the view ends here
    ImGui::SetCursorScreenPos(keep);
    const ImVec2 bar_low{left + 2.0F * scale, card_low.y + title + field + 18.0F * scale};
    const ImVec2 bar_high{bar_low.x + bar_width * scale, card_high.y - field - 18.0F * scale};
    draw_bar(list, state.options, bar_low, bar_high);
    draw_ticks(list, state.options, bar_low, bar_high);
    widgets.note("legend", {card_low.x, card_low.y, card_high.x, card_high.y});
}

}  // namespace hanei
