#include "ui/panels/compare_panel.h"
#include "ui/panels/form.h"
#include "ui/panels/illuminance_text.h"
#include "ui/panels/language.h"
#include "ui/panels/style.h"
#include "ui/view/colour_scale.h"
#include "ui/view/value_labels.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <imgui.h>

namespace hanei {
namespace {

constexpr float card_width = 88.0F, bar_width = 16.0F, greatest_height = 330.0F;

ImU32 packed(const glm::vec3& colour) { return ImGui::ColorConvertFloat4ToU32({colour.r, colour.g, colour.b, 1.0F}); }

/// From more to less; less is striped as in the picture.
void draw_bar(ImDrawList& list, const ViewOptions& look, ImVec2 low, ImVec2 high) {
    const int rows = static_cast<int>(high.y - low.y);
    for (int k = 0; k < rows; ++k) {
        const double lux = lux_at(1.0 - (k + 0.5) / rows, look);
        const float y = low.y + static_cast<float>(k);
        list.AddRectFilled({low.x, y}, {high.x, y + 1.0F}, packed(colour_of(lux, look)));
    }
    const float middle = 0.5F * (low.y + high.y), step = 6.0F * style::scale(), width = high.x - low.x;
    list.PushClipRect({low.x, middle + 2.0F}, high, true);
    for (float y = middle - width; y < high.y; y += step)
        list.AddLine({low.x, y}, {high.x, y + width}, IM_COL32(0, 0, 0, 72), 1.5F * style::scale());
    list.PopClipRect();
}

}  // namespace

void difference_legend(Snapshots& snapshots, LightPart part, const ScreenRect& view, WidgetRegistry& widgets) {
    const float scale = style::scale(), field = ImGui::GetFrameHeight();
    const float line = style::fonts().small->FontSize;
    const float height = std::min(greatest_height * scale, view.bottom - view.top - 24.0F * scale);
    if (height < 170.0F * scale) return;
    ViewOptions look;
    look.difference = true;
    look.unit = illuminance_unit();
    look.range.high = snapshots.range_of(part);
    const ImVec2 low{view.right - (card_width + 12.0F) * scale, view.top + 12.0F * scale};
    const ImVec2 high{view.right - 12.0F * scale, low.y + height};
    ImDrawList& list = *ImGui::GetWindowDrawList();
    list.AddRectFilled(low, high, style::card, 6.0F * scale);
    const float left = low.x + 8.0F * scale;
    const auto write = [&](ImVec2 at, const std::string& text, ImU32 colour) {
        list.AddText(style::fonts().small, line, at, colour, text.c_str());
    };
    const ImU32 bright = style::text, pale = style::quiet_text;
    write({left, low.y + 7.0F * scale}, fmt::format("B − A  {}", illuminance_unit_name()), pale);
    const ImVec2 keep = ImGui::GetCursorScreenPos();
    ImGui::SetCursorScreenPos({left, low.y + line + 12.0F * scale});
    ImGui::SetNextItemWidth((card_width - 16.0F) * scale);
    const double unit = lux_in(illuminance_unit()), least = 0.1, most = 1e6;
    double shown = look.range.high / unit;
    if (ImGui::DragScalar("##difference", ImGuiDataType_Double, &shown, static_cast<float>(0.01 * shown), &least, &most,
                          shown < 10.0 ? "± %.1f" : "± %.0f", ImGuiSliderFlags_AlwaysClamp) &&
        std::isfinite(shown))
        snapshots.range = shown * unit;
    widgets.note("legend.difference");
    tooltip(tr("The greatest difference that the colours tell: drag, or click and type"));
    ImGui::SetCursorScreenPos(low);
    ImGui::InvisibleButton("difference card", {high.x - low.x, high.y - low.y});  // the view ends here
    ImGui::SetCursorScreenPos(keep);
    const float foot = 2.0F * line + 14.0F * scale;
    const ImVec2 bar_low{left + 2.0F * scale, low.y + line + field + 24.0F * scale};
    const ImVec2 bar_high{bar_low.x + bar_width * scale, high.y - foot - 10.0F * scale};
    draw_bar(list, look, bar_low, bar_high);
    for (const double share : {-1.0, -0.5, 0.0, 0.5, 1.0}) {
        const double lux = share * look.range.high;
        const float y = bar_high.y - static_cast<float>(legend_position(lux, look)) * (bar_high.y - bar_low.y);
        list.AddLine({bar_high.x + 2.0F, y}, {bar_high.x + 6.0F, y}, pale);
        write({bar_high.x + 10.0F * scale, y - 0.5F * line}, value_text(lux, look), bright);
    }
    const float swatch = 10.0F * scale, y = high.y - foot;
    list.AddRectFilled({left + 2.0F * scale, y}, {left + 2.0F * scale + swatch, y + swatch},
                       packed(difference_colours.nothing));
    write({left + swatch + 8.0F * scale, y - 0.1F * line}, tr("nothing"), pale);
    write({left + swatch + 8.0F * scale, y + 0.9F * line}, tr("to compare"), pale);
    widgets.note("difference_legend", {low.x, low.y, high.x, high.y});
}

}  // namespace hanei
