#include "ui/panels/study_plot.h"

#include "engine/report/sweep_look.h"
#include "engine/report/sweep_report.h"
#include "ui/panels/language.h"
#include "ui/panels/photometry_plot.h"
#include "ui/panels/plot_frame.h"
#include "ui/panels/style.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <imgui.h>

namespace hanei {
namespace {

ImU32 packed(std::uint32_t colour, float opacity) {
    return IM_COL32((colour >> 16) & 0xff, (colour >> 8) & 0xff, colour & 0xff,
                    static_cast<int>(255.0F * opacity + 0.5F));
}

/// Of a point in the plot, kept within its ends.
struct Mapping {
    const PlotFrame& frame;
    SweepRange range;
    ImVec2 at(double ms, double share) const {
        return frame.at(1e-3 * std::clamp(ms, range.fastest, range.slowest),
                        std::clamp(100.0 * share, range.least, range.greatest));
    }
    ImVec2 at(const SweepPoint& point) const { return at(point.milliseconds, point.errors.front().p95); }
};

void draw_marker(const SweepPoint& point, ImVec2 at) {
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const float size = static_cast<float>(marker_size(point)) * style::scale();
    const ImU32 colour = packed(colour_of(point.settings.method), point.complete ? 1.0F : 0.5F);
    std::vector<ImVec2> corners;
    for (const auto& [x, y] : marker_corners(point.settings.method))
        corners.push_back({at.x + size * static_cast<float>(x), at.y + size * static_cast<float>(y)});
    const int count = static_cast<int>(corners.size());
    if (corners.empty() && point.shadows)
        list.AddCircleFilled(at, size, colour);
    else if (corners.empty())
        list.AddCircle(at, size, colour, 0, 1.3F * style::scale());
    else if (point.shadows)
        list.AddConvexPolyFilled(corners.data(), count, colour);
    else
        list.AddPolyline(corners.data(), count, colour, ImDrawFlags_Closed, 1.3F * style::scale());
}

void draw_frontier(const Sweep& sweep, const Mapping& mapping) {
    std::vector<ImVec2> steps;
    for (const SweepPoint* point : frontier_of(sweep)) {
        const ImVec2 at = mapping.at(point->milliseconds, std::max(point->errors.front().p95, sweep.uncertainty.p95));
        if (!steps.empty()) steps.push_back({at.x, steps.back().y});
        steps.push_back(at);
    }
    if (steps.empty()) return;
    steps.push_back({mapping.frame.high().x, steps.back().y});
    PlaneCurve look;
    look.colour = ImGui::GetColorU32(ImGuiCol_Text, 0.8F);
    stroke(*ImGui::GetWindowDrawList(), steps, look);
}

void small_text(ImVec2 at, const std::string& text, ImU32 colour) {
    ImFont* font = style::fonts().small;
    ImGui::GetWindowDrawList()->AddText(font, font->FontSize, at, colour, text.c_str());
}

float width_of(const std::string& text) {
    ImFont* font = style::fonts().small;
    return font->CalcTextSizeA(font->FontSize, 1e4F, 0.0F, text.c_str()).x;
}

/// Methods at the upper right, from right to left.
void draw_key(const Mapping& mapping) {
    const float scale = style::scale(), letters = style::fonts().small->FontSize;
    float x = mapping.frame.high().x;
    const float y = mapping.frame.low().y - letters - 2.0F * scale;
    for (auto method = methods.rbegin(); method != methods.rend(); ++method) {
        const std::string name(name_of(*method));
        x -= width_of(name);
        small_text({x, y}, name, ImGui::GetColorU32(ImGuiCol_Text));
        SweepPoint example;
        example.settings.method = *method;
        draw_marker(example, {x - 9.0F * scale, y + 0.55F * letters});
        x -= 26.0F * scale;
    }
}

bool is_present(const SweepPoint& point, const Settings& present) {
    const int most = point.settings.bounces;
    const bool same_bounces = most == present.bounces || (point.complete && present.bounces > most);
    return point.shadows && point.settings.method == present.method && same_bounces &&
           point.settings.max_patch == present.max_patch && point.settings.accuracy == present.accuracy;
}

void draw_names(const Sweep& sweep, const Settings& present, const Mapping& mapping) {
    const float scale = style::scale();
    ImDrawList& list = *ImGui::GetWindowDrawList();
    for (const SweepPoint& point : sweep.points) {
        const ImVec2 at = mapping.at(point);
        const bool here = is_present(point, present);
        if (here) list.AddCircle(at, 10.0F * scale, ImGui::GetColorU32(ImGuiCol_Text), 0, 2.0F * scale);
        std::string name;
        if (point.marks.preset) name = tr(std::string(name_of(*point.marks.preset)).c_str());
        if (point.marks.paper) name = tr("the paper's own");
        if (here) name = tr("now");
        if (!name.empty())
            small_text({std::min(at.x + 11.0F * scale, mapping.frame.high().x - width_of(name)), at.y - 6.0F * scale},
                       name, ImGui::GetColorU32(ImGuiCol_Text));
    }
}

std::vector<std::string> card_of(const SweepPoint& point) {
    const SweepErrors& errors = point.errors.front();
    std::vector<std::string> lines{
        words_of(point), say("took {}, {} unknowns", time_text(point.milliseconds), point.unknowns),
        say("95 of 100 points within {} ({:.1f} lx)", percent_text(errors.p95), errors.p95_lux),
        say("mean {}, greatest {}", percent_text(errors.mean), percent_text(errors.max))};
    if (point.marks.preset)
        lines.push_back(say("predicted {}, {}", time_text(point.predicted.ms), percent_text(point.predicted.error)));
    return lines;
}

/// The point nearest to the pointer, when it is close.
std::optional<std::size_t> pointed_at(const Sweep& sweep, const Mapping& mapping) {
    const ImVec2 mouse = ImGui::GetIO().MousePos;
    float closest = 12.0F * style::scale();
    std::optional<std::size_t> nearest;
    for (std::size_t k = 0; k < sweep.points.size(); ++k) {
        const ImVec2 at = mapping.at(sweep.points[k]);
        const float away = std::hypot(at.x - mouse.x, at.y - mouse.y);
        if (away >= closest) continue;
        closest = away;
        nearest = k;
    }
    return nearest;
}

}  // namespace

std::optional<Settings> study_plot(const Sweep& sweep, const Settings& present, WidgetRegistry& widgets) {
    const SweepRange range = range_of(sweep);
    const PlotFrame frame("study.plot", {1e-3 * range.fastest, 1e-3 * range.slowest, tr("Time  s"), true},
                          {range.least, range.greatest, tr("Error of 95 of 100 points  %"), true},
                          ImGui::GetContentRegionAvail().y, widgets);
    const bool hovered = ImGui::IsItemHovered(), clicked = ImGui::IsItemClicked();
    if (!frame.has_room()) return std::nullopt;
    const Mapping mapping{frame, range};
    ImDrawList& list = *ImGui::GetWindowDrawList();
    if (sweep.uncertainty.p95 > 0.0) {
        const ImVec2 upper = mapping.at(range.fastest, sweep.uncertainty.p95);
        list.AddRectFilled(upper, frame.high(), ImGui::GetColorU32(ImGuiCol_TextDisabled, 0.18F));
    }
    draw_frontier(sweep, mapping);
    for (std::size_t k = 0; k < sweep.points.size(); ++k) {
        const ImVec2 at = mapping.at(sweep.points[k]);
        draw_marker(sweep.points[k], at);
        const float half = 4.0F * style::scale();
        widgets.note(fmt::format("study.point.{}", k), {at.x - half, at.y - half, at.x + half, at.y + half});
    }
    draw_names(sweep, present, mapping);
    draw_key(mapping);
    if (!hovered) return std::nullopt;
    const auto pointed = pointed_at(sweep, mapping);
    if (!pointed) return std::nullopt;
    const SweepPoint& point = sweep.points[*pointed];
    list.AddCircle(mapping.at(point), 8.0F * style::scale(), ImGui::GetColorU32(ImGuiCol_Text), 0,
                   1.5F * style::scale());
    plot_card(frame, mapping.at(point), card_of(point));
    if (!clicked || !point.shadows) return std::nullopt;
    return point.settings;
}

}  // namespace hanei
