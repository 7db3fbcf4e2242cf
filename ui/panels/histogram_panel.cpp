#include "ui/panels/histogram_panel.h"

#include "engine/edit/edit.h"
#include "ui/panels/elided.h"
#include "ui/panels/form.h"
#include "ui/panels/illuminance_text.h"
#include "ui/panels/language.h"
#include "ui/panels/panel_frame.h"
#include "ui/panels/plot_frame.h"
#include "ui/panels/style.h"
#include "ui/view/colour_scale.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <imgui.h>

namespace hanei {
namespace {

constexpr float facts_width = 230.0F;

void fact(const char* label, const std::string& value) {
    ImGui::TextColored(style::colour(style::quiet_text), "%s", label);
    ImGui::SameLine(facts_width * style::scale() - ImGui::CalcTextSize(value.c_str()).x - 22.0F * style::scale());
    ImGui::TextUnformatted(value.c_str());
}

void mark_line(const PlotFrame& frame, double x, const char* text, float row) {
    const ImVec2 foot = frame.at(x, 0.0);
    if (foot.x < frame.low().x - 1.0F || foot.x > frame.high().x + 1.0F) return;
    ImDrawList& list = *ImGui::GetWindowDrawList();
    list.AddLine({foot.x, frame.low().y}, foot, ImGui::GetColorU32(ImGuiCol_Text, 0.75F), 1.4F * style::scale());
    ImFont* font = style::fonts().small;
    const float width = font->CalcTextSizeA(font->FontSize, 1e4F, 0.0F, text).x;
    const bool left = foot.x + width + 6.0F * style::scale() > frame.high().x;
    list.AddText(font, font->FontSize,
                 {left ? foot.x - width - 4.0F * style::scale() : foot.x + 4.0F * style::scale(),
                  frame.low().y + row * (font->FontSize + 1.0F)},
                 ImGui::GetColorU32(ImGuiCol_Text), text);
}

}  // namespace

void HistogramPanel::facts(WidgetRegistry& widgets) {
    headline(name_, "");
    widgets.note("histogram.of");
    fact(tr("Mean"), illuminance_text(made_.mean));
    fact(tr("Least"), illuminance_text(made_.least));
    fact(tr("Greatest"), illuminance_text(made_.greatest));
    fact(tr("Uniformity U0"), fmt::format("{:.2f}", made_.uniformity()));
    fact(tr("Area"), fmt::format("{:.1f} m²", made_.area));
    ImGui::Separator();
    for (const double level : levels_)
        fact(fmt::format("{} {} {}", tr("At least"), illuminance_figure(level), illuminance_unit_name()).c_str(),
             fmt::format("{:.0f} %", 100.0 * made_.share_above(level)));
}

void HistogramPanel::plot(const ViewOptions& look, WidgetRegistry& widgets) const {
    const double unit = lux_in(illuminance_unit());
    double fullest = 0.0;
    for (const LightHistogram::Bin& bin : made_.bins) fullest = std::max(fullest, 100.0 * bin.area / made_.area);
    PlotAxis across{made_.bins.front().low / unit, made_.bins.back().high / unit,
                    fmt::format("{}  {}", tr("Illuminance"), illuminance_unit_name()),
                    look.steps != ColourSteps::linear};
    PlotAxis up{0.0, fullest > 0.0 ? 1.15 * fullest : 1.0, tr("Share of the area  %")};
    const PlotFrame frame("histogram.plot", std::move(across), std::move(up), ImGui::GetContentRegionAvail().y,
                          widgets);
    if (!frame.has_room()) return;
    ImDrawList& list = *ImGui::GetWindowDrawList();
    for (const LightHistogram::Bin& bin : made_.bins) {
        if (!(bin.area > 0.0)) continue;
        const ImVec2 low = frame.at(bin.low / unit, 100.0 * bin.area / made_.area);
        const ImVec2 high = frame.at(bin.high / unit, 0.0);
        const glm::vec3 colour = colour_of(std::sqrt(std::max(0.0, bin.low * bin.high)), look);
        list.AddRectFilled(low, {std::max(low.x + 1.0F, high.x - 1.0F), high.y},
                           ImGui::ColorConvertFloat4ToU32({colour.r, colour.g, colour.b, 1.0F}));
        list.AddRect(low, {std::max(low.x + 1.0F, high.x - 1.0F), high.y}, ImGui::GetColorU32(ImGuiCol_Text, 0.35F));
    }
    mark_line(frame, made_.mean / unit, tr("mean"), 0.0F);
    for (const double level : levels_) {
        const float x = frame.at(level / unit, 0.0).x;
        if (x > frame.low().x && x < frame.high().x)
            list.AddLine({x, frame.high().y - 5.0F * style::scale()}, {x, frame.high().y},
                         ImGui::GetColorU32(ImGuiCol_Text), 1.5F * style::scale());
    }
    if (!frame.pointed()) return;
    const double lux = *frame.pointed() * unit;
    for (const LightHistogram::Bin& bin : made_.bins) {
        if (lux < bin.low || lux >= bin.high) continue;
        plot_card(frame, ImGui::GetIO().MousePos,
                  {fmt::format("{} – {} {}", illuminance_figure(bin.low), illuminance_figure(bin.high),
                               illuminance_unit_name()),
                   fmt::format("{:.1f} m²   {:.1f} %", bin.area, 100.0 * bin.area / made_.area),
                   fmt::format("{} {:.0f} %", tr("at least this:"), 100.0 * made_.share_above(bin.low))});
    }
}

void HistogramPanel::table(const SolutionSnapshot& solution, ObjectId chosen, const ViewOptions& look,
                           WidgetRegistry& widgets) {
    if (!solution || !solution->display) {
        quiet_words(tr("The first values are being computed."));
        return;
    }
    const bool of_grid = kind_of(*solution->scene, chosen) == ObjectKind::grid;
    const Key key{solution, of_grid ? chosen : ObjectId{}, look.part, look.steps};
    if (key != key_) {
        key_ = key;
        made_ = histogram_of(*solution, key.grid, look);
    }
    name_ = of_grid ? display_name(*solution->scene, chosen) : std::string(tr("All surfaces"));
    levels_ = look.isolux_levels;
    if (levels_.empty())
        for (const double level : {100.0, 200.0, 300.0, 500.0, 750.0, 1000.0}) levels_.push_back(level);
    if (made_.samples.empty()) {
        quiet_words(tr("There are no values of this part of the light here."));
        return;
    }
    ImGui::BeginChild("histogram facts", {facts_width * style::scale(), 0.0F});
    facts(widgets);
    ImGui::EndChild();
    ImGui::SameLine(0.0F, 14.0F * style::scale());
    ImGui::BeginChild("histogram plot", {0.0F, 0.0F});
    if (!made_.bins.empty()) plot(look, widgets);
    ImGui::EndChild();
}

}  // namespace hanei
