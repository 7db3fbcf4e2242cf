#include "ui/panels/language.h"
#include "ui/panels/style.h"
#include "ui/panels/view_bar.h"
#include "ui/view/class_colours.h"
#include "ui/view/legend.h"

#include <algorithm>
#include <imgui.h>

namespace hanei {
namespace {

constexpr float card_width = 168.0F;
constexpr float row_height = 40.0F;
constexpr float swatch = 22.0F;

ImU32 shown(const glm::vec3& colour) { return ImGui::ColorConvertFloat4ToU32({colour.r, colour.g, colour.b, 1.0F}); }

void draw_swatch(ImDrawList& list, LightClass kind, ImVec2 low, float size) {
    const ImVec2 high{low.x + size, low.y + size};
    list.AddRectFilled(low, high, shown(class_colours[static_cast<std::size_t>(kind)]), 2.0F);
    if (kind == LightClass::partly) {
        list.PushClipRect(low, high, true);
        const float step = static_cast<float>(hatching_px) * style::scale();
        for (float at = 0.5F * step; at < 2.0F * size; at += step)
            list.AddLine({low.x + at, low.y}, {low.x, low.y + at}, shown(hatching_colour), 1.5F * style::scale());
        list.PopClipRect();
    }
    list.AddRect(low, high, style::border, 2.0F);
}

std::string shortened(const std::string& text, const ImFont& font, float room) {
    std::string fitting = text;
    while (fitting.size() > 1 && font.CalcTextSizeA(font.FontSize, 1e4F, 0.0F, fitting.c_str()).x > room)
        fitting.pop_back();
    while (!fitting.empty() && (fitting.back() & 0xC0) == 0x80 && fitting != text) fitting.pop_back();
    return fitting == text ? text : fitting + "…";
}

}  // namespace

void class_legend(const ViewOptions& look, const SolutionSnapshot& solution, const ScreenRect& view,
                  WidgetRegistry& widgets) {
    const float scale = style::scale();
    const std::vector<ClassRow> rows = class_rows(solution.get(), look);
    const ImFont& small = *style::fonts().small;
    const float line = small.FontSize;
    const float head = 2.0F * line + 22.0F * scale;
    const ImVec2 low{view.right - (card_width + 12.0F) * scale, view.top + 12.0F * scale};
    const ImVec2 high{view.right - 12.0F * scale, low.y + head + 4.0F * row_height * scale};
    ImDrawList& list = *ImGui::GetWindowDrawList();
    list.AddRectFilled(low, high, style::card, 6.0F * scale);
    const float left = low.x + 10.0F * scale;
    const auto write = [&](ImVec2 at, const std::string& text, ImU32 colour) {
        list.AddText(&small, line, at, colour, text.c_str());
    };
    const bool any = solution && solution->shadows;
    const std::string of =
        any ? say("of {}", shadows_of_text(*solution->scene, look.shadows_of)) : tr("being worked out");
    write({left, low.y + 8.0F * scale}, tr("Shadow classes"), style::text);
    write({left, low.y + 10.0F * scale + line}, shortened(of, small, (card_width - 24.0F) * scale), style::quiet_text);
    float y = low.y + head;
    for (const ClassRow& row : rows) {
        draw_swatch(list, row.kind, {left, y}, swatch * scale);
        const float text = left + (swatch + 9.0F) * scale;
        write({text, y - 4.0F * scale}, row.name, style::text);
        write({text, y - 3.0F * scale + line}, row.counts, style::quiet_text);
        y += row_height * scale;
    }
    widgets.note("class_legend", {low.x, low.y, high.x, high.y});
}

}  // namespace hanei
