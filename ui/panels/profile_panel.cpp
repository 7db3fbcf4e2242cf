#include "ui/panels/profile_panel.h"

#include "ui/panels/elided.h"
#include "ui/panels/form.h"
#include "ui/panels/illuminance_text.h"
#include "ui/panels/language.h"
#include "ui/panels/photometry_plot.h"
#include "ui/panels/plot_frame.h"
#include "ui/panels/style.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>
#include <imgui.h>

namespace hanei {
namespace {

constexpr std::size_t values_a_frame = 12;
constexpr float field_width = 262.0F;

struct CurveLook {
    const char* name;
    double (*value)(const PointValue&);
    style::Colour colour;
    bool dashed;
};
const std::array curves{
    CurveLook{"Total", [](const PointValue& value) { return value.total().value; }, style::accent, false},
    CurveLook{"Direct", [](const PointValue& value) { return value.direct.value; }, style::second, false},
    CurveLook{"Interreflected", [](const PointValue& value) { return value.interreflected.value; }, style::good, true}};

/// Three typed figures in a row.
bool place_fields(const char* label, const char* name, Vec3& place, const char* help, WidgetRegistry& widgets) {
    ImGui::AlignTextToFramePadding();
    ImGui::TextColored(style::colour(style::quiet_text), "%s", tr(label));
    ImGui::SameLine(58.0F * style::scale());
    double figures[] = {place.x, place.y, place.z};
    ImGui::SetNextItemWidth(-22.0F * style::scale());
    const bool changed = ImGui::DragScalarN(fmt::format("##{}", name).c_str(), ImGuiDataType_Double, figures, 3, 0.01F,
                                            nullptr, nullptr, "%.2f");
    widgets.note(name);
    tooltip(tr(help));
    ImGui::SameLine(0.0F, 4.0F * style::scale());
    ImGui::TextColored(style::colour(style::quiet_text), "m");
    const Vec3 wished(figures[0], figures[1], figures[2]);
    if (!changed || !std::isfinite(glm::dot(wished, wished))) return false;
    place = wished;
    return true;
}

/// Of one curve, in pieces where the line passes through furniture.
void draw_curve(const PlotFrame& frame, const std::vector<ProfileSample>& samples, const CurveLook& look, double unit) {
    PlaneCurve stroke_look;
    stroke_look.colour = look.colour;
    stroke_look.dashed = look.dashed;
    std::vector<ImVec2> piece;
    const auto finish = [&] {
        if (piece.size() > 1) stroke(*ImGui::GetWindowDrawList(), piece, stroke_look);
        piece.clear();
    };
    for (const ProfileSample& sample : samples) {
        if (sample.value.inside_solid)
            finish();
        else
            piece.push_back(frame.at(sample.along, look.value(sample.value) / unit));
    }
    finish();
}

void draw_key(const PlotFrame& frame) {
    const float scale = style::scale();
    ImDrawList& list = *ImGui::GetWindowDrawList();
    ImFont* font = style::fonts().small;
    float x = frame.high().x;
    for (auto look = curves.rbegin(); look != curves.rend(); ++look) {
        const char* const text = tr(look->name);
        const float width = font->CalcTextSizeA(font->FontSize, 1e4F, 0.0F, text).x;
        x -= width;
        const float y = frame.low().y - font->FontSize - 2.0F * scale;
        list.AddText(font, font->FontSize, {x, y}, ImGui::GetColorU32(ImGuiCol_Text), text);
        PlaneCurve stroke_look;
        stroke_look.colour = look->colour;
        stroke_look.dashed = look->dashed;
        const float middle = y + 0.5F * font->FontSize + 1.0F;
        stroke(list, {{x - 28.0F * scale, middle}, {x - 6.0F * scale, middle}}, stroke_look);
        x -= 44.0F * scale;
    }
}

const ProfileSample* nearest_to(const std::vector<ProfileSample>& samples, double along) {
    const ProfileSample* nearest = nullptr;
    for (const ProfileSample& sample : samples)
        if (nearest == nullptr || std::abs(sample.along - along) < std::abs(nearest->along - along)) nearest = &sample;
    return nearest;
}

}  // namespace

void ProfilePanel::fields(Outcome& outcome, WidgetRegistry& widgets) {
    outcome.draws_line = ImGui::Button(tr("Draw a line"));
    widgets.note("profile.draw");
    tooltip(tr("Press the left button on a surface, pull, and let go  (L)"));
    ImGui::SameLine();
    outcome.exports = ImGui::Button(tr("Export")) && sampler_;
    widgets.note("profile.export");
    tooltip(tr("Write place, total, direct and interreflected light and error bar of every value as CSV"));
    ProfileLine line = line_.value_or(ProfileLine{{0.5, 0.5, 0.75}, {2.5, 0.5, 0.75}, {0.0, 0.0, 1.0}});
    bool changed = place_fields("From", "profile.from", line.from, "Where the line begins: x, y, z", widgets);
    changed |= place_fields("To", "profile.to", line.to, "Where the line ends: x, y, z", widgets);
    changed |= place_fields("Facing", "profile.normal", line.normal,
                            "The direction that the places along the line face: x, y, z; up is 0, 0, 1", widgets);
    if (changed) line_ = line;
}

void ProfilePanel::plot(WidgetRegistry& widgets) {
    const std::vector<ProfileSample>& samples = sampler_->samples();
    const double unit = lux_in(illuminance_unit());
    double greatest = 0.0;
    for (const ProfileSample& sample : samples) greatest = std::max(greatest, sample.value.total().value / unit);
    PlotAxis across{0.0, sampler_->line().length(), tr("Distance  m")};
    PlotAxis up{0.0, greatest > 0.0 ? 1.08 * greatest : 1.0,
                fmt::format("{}  {}", tr("Illuminance"), illuminance_unit_name())};
    const PlotFrame frame("profile.plot", std::move(across), std::move(up), ImGui::GetContentRegionAvail().y, widgets);
    pointed_ = frame.pointed();
    if (!frame.has_room()) return;
    for (auto look = curves.rbegin(); look != curves.rend(); ++look) draw_curve(frame, samples, *look, unit);
    draw_key(frame);
    const ProfileSample* const sample = pointed_ ? nearest_to(samples, *pointed_) : nullptr;
    if (sample == nullptr) return;
    const ImVec2 at = frame.at(sample->along, sample->value.total().value / unit);
    ImDrawList& list = *ImGui::GetWindowDrawList();
    list.AddLine({at.x, frame.low().y}, {at.x, frame.high().y}, ImGui::GetColorU32(ImGuiCol_TextDisabled));
    std::vector<std::string> lines{fmt::format("{:.2f} m", sample->along)};
    if (sample->value.inside_solid) {
        lines.emplace_back(tr("inside furniture"));
    } else {
        for (const CurveLook& look : curves) {
            const double lux = look.value(sample->value);
            list.AddCircleFilled(frame.at(sample->along, lux / unit), 3.5F * style::scale(), look.colour);
            lines.push_back(fmt::format("{}  {}", tr(look.name), illuminance_text(lux)));
        }
        lines.front() += fmt::format("   ± {}", illuminance_figure(sample->value.error.total()));
    }
    plot_card(frame, at, lines);
}

ProfilePanel::Outcome ProfilePanel::table(const SolutionSnapshot& solution, WidgetRegistry& widgets) {
    was_drawn_ = true;
    Outcome outcome;
    ImGui::BeginChild("profile fields", {field_width * style::scale(), 0.0F});
    fields(outcome, widgets);
    ImGui::EndChild();
    ImGui::SameLine(0.0F, 14.0F * style::scale());
    ImGui::BeginChild("profile plot", {0.0F, 0.0F});
    pointed_.reset();
    if (!line_ || !(line_->length() > 0.0)) {
        quiet_words(tr("Draw a line on a surface, or type where it begins and ends."));
    } else if (solution) {
        if (!sampler_ || sampler_->solution() != solution || sampler_->line().from != line_->from ||
            sampler_->line().to != line_->to || asked_normal_ != line_->normal) {
            sampler_.emplace(solution, *line_);
            asked_normal_ = line_->normal;
        }
        sampler_->advance(values_a_frame);
        if (!sampler_->samples().empty()) plot(widgets);
    }
    ImGui::EndChild();
    return outcome;
}

void ProfilePanel::draw(const PaneSight& sight, WidgetRegistry& /*widgets*/) {
    if (!line_ || !was_drawn_) return;
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const float scale = style::scale();
    for (const std::vector<ImVec2>& piece : sight.pane.on_screen(std::vector<Vec3>{line_->from, line_->to})) {
        const int count = static_cast<int>(piece.size());
        list.AddPolyline(piece.data(), count, IM_COL32(10, 12, 14, 170), ImDrawFlags_None, 5.0F * scale);
        list.AddPolyline(piece.data(), count, IM_COL32(250, 250, 250, 245), ImDrawFlags_None, 2.2F * scale);
    }
    if (const auto begin = sight.pane.on_screen(line_->from))
        list.AddCircleFilled(*begin, 4.5F * scale, IM_COL32(250, 250, 250, 255));
    if (!pointed_) return;
    if (const auto at = sight.pane.on_screen(line_->at(*pointed_))) {
        list.AddCircleFilled(*at, 6.5F * scale, IM_COL32(10, 12, 14, 200));
        list.AddCircleFilled(*at, 5.0F * scale, style::accent);
    }
}

}  // namespace hanei
