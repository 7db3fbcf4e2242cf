#include "ui/panels/measure_tool.h"

#include "ui/panels/language.h"
#include "ui/panels/sketch.h"
#include "ui/panels/style.h"
#include "ui/panels/units.h"
#include "ui/view/standpoint.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <imgui.h>

namespace hanei {
namespace {

constexpr float reach = 10.0F;  // pixels that a corner catches in
constexpr double least = 1e-4;  // m that are drawn

const char* name_of(Catch caught) {
    switch (caught) {
        case Catch::corner:
            return "corner";
        case Catch::centre:
            return "centre";
        case Catch::edge:
            return "edge";
        case Catch::raster:
            return "raster";
        case Catch::none:
            break;
    }
    return "";
}

std::string length_text(double metres) { return with_unit(metres, "m", 3); }

/// The parts along the axes that are not nothing.
std::string parts_text(const Vec3& distance) {
    std::string text;
    for (int axis = 0; axis < 3; ++axis) {
        if (std::abs(distance[axis]) < 5e-4) continue;
        text += fmt::format("{}d{} {}", text.empty() ? "" : "   ", "xyz"[axis], length_text(std::abs(distance[axis])));
    }
    return text;
}

/// Which kind of place is under the pointer, by its shape.
void draw_catch(const Pane& pane, const MeasurePoint& point) {
    const auto at = pane.on_screen(point.place);
    if (!at) return;
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const float scale = style::scale(), half = 5.5F * scale;
    const ImU32 ink = style::accent;
    if (point.caught == Catch::corner)
        list.AddRect({at->x - half, at->y - half}, {at->x + half, at->y + half}, ink, 0.0F, ImDrawFlags_None,
                     1.8F * scale);
    else if (point.caught == Catch::centre)
        list.AddCircle(*at, half, ink, 0, 1.8F * scale);
    else if (point.caught == Catch::edge)
        list.AddTriangle({at->x, at->y - half}, {at->x + half, at->y + half}, {at->x - half, at->y + half}, ink,
                         1.8F * scale);
    sketch::dot(*at, 2.0F, ink);
    if (point.caught == Catch::none || point.caught == Catch::raster) return;
    sketch::chip({at->x + 34.0F * scale, at->y - 18.0F * scale}, tr(name_of(point.caught)), style::quiet_text);
}

/// Small strokes across the ends of a line on the screen.
void draw_ends(const Pane& pane, const Vec3& from, const Vec3& to) {
    const auto a = pane.on_screen(from), b = pane.on_screen(to);
    if (!a || !b) return;
    const float length = std::max(1.0F, std::hypot(b->x - a->x, b->y - a->y)), half = 6.0F * style::scale();
    const ImVec2 across{half * (b->y - a->y) / length, half * (a->x - b->x) / length};
    for (const ImVec2& end : {*a, *b})
        ImGui::GetWindowDrawList()->AddLine({end.x - across.x, end.y - across.y}, {end.x + across.x, end.y + across.y},
                                            style::accent, 1.8F * style::scale());
}

}  // namespace

ViewTool::Outcome MeasureTool::handle(const PaneSight& sight) {
    under_.reset();
    if (!sight.hovered) return {};
    if (kept_.scene != sight.scene) kept_ = {sight.scene, measure_marks(*sight.scene)};
    const ImGuiIO& io = ImGui::GetIO();
    under_ = measure_point(*sight.scene, kept_.marks, sight.pane, io.MousePos, sight.raster, reach * style::scale(),
                           !io.KeyCtrl);
    if (!under_) return {};
    if (first_ && !second_ && standpoint_of(sight.pane.camera)) {
        const Vec3 sightline = axes_of(sight.pane.camera).forward;
        under_->place -= glm::dot(under_->place - *first_, sightline) * sightline;
    }
    if (!ImGui::IsMouseClicked(ImGuiMouseButton_Left)) return {};
    if (!first_ || second_) {
        first_ = under_->place;
        second_.reset();
    } else {
        second_ = under_->place;
    }
    return {};
}

std::optional<Vec3> MeasureTool::distance() const {
    if (!first_) return std::nullopt;
    if (second_) return *second_ - *first_;
    if (!under_) return std::nullopt;
    return under_->place - *first_;
}

void MeasureTool::draw(const PaneSight& sight, WidgetRegistry& widgets) const {
    const Pane& pane = sight.pane;
    if (const std::optional<Vec3> between = distance(); between && glm::length(*between) > least) {
        const Vec3 to = *first_ + *between;
        sketch::line(pane, {*first_, to}, style::accent, 2.0F);
        draw_ends(pane, *first_, to);
        const auto middle = pane.on_screen(*first_ + 0.5 * *between);
        if (middle) {
            const float line = ImGui::GetTextLineHeight(), scale = style::scale();
            const std::string text = length_text(glm::length(*between)), parts = parts_text(*between);
            ImGui::PushFont(style::fonts().strong);
            sketch::chip({middle->x, middle->y - 1.3F * line}, text, style::accent);
            const float half = 0.5F * ImGui::CalcTextSize(text.c_str()).x;
            ImGui::PopFont();
            if (!parts.empty())
                sketch::chip({middle->x, middle->y - 1.3F * line + line + 7.0F * scale}, parts, style::text);
            if (sight.number == 0)
                widgets.note("measure.distance",
                             {middle->x - half, middle->y - 1.8F * line, middle->x + half, middle->y - 0.8F * line});
        }
    } else if (first_) {
        if (const auto at = pane.on_screen(*first_)) sketch::dot(*at, 4.0F, style::accent);
    }
    if (under_ && sight.hovered) draw_catch(pane, *under_);
}

std::string MeasureTool::hint() const {
    if (!first_) return tr("Click where the distance begins; Ctrl does not catch, Esc ends");
    if (!second_) return tr("Click where the distance ends; Esc ends measuring");
    return tr("Click to measure anew; Esc ends measuring");
}

}  // namespace hanei
