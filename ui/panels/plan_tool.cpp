#include "ui/panels/plan_tool.h"

#include "engine/edit/plan_edits.h"
#include "engine/edit/plan_shape.h"
#include "ui/panels/drag.h"
#include "ui/panels/language.h"
#include "ui/panels/sketch.h"
#include "ui/panels/style.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fmt/format.h>
#include <numbers>

namespace hanei {
namespace {

constexpr double reach = 1e4;     // m
constexpr float closing = 12.0F;  // pixels around the first corner that close the plan
constexpr double turn_step = std::numbers::pi / 12.0;

bool pressed(Key key) { return ImGui::IsKeyPressed(static_cast<int>(key), key == Key::backspace); }

float distance(ImVec2 a, ImVec2 b) { return std::hypot(a.x - b.x, a.y - b.y); }

/// The length that was typed, m; 0 when it is none yet.
double length_of(const std::string& typed) { return typed.empty() ? 0.0 : std::atof(typed.c_str()); }

}  // namespace

bool PlanTool::takes(const Chord& chord) const {
    if (chord.control || chord.alt) return false;
    const int key = static_cast<int>(chord.key);
    return chord.key == Key::enter || chord.key == Key::keypad_enter || chord.key == Key::backspace ||
           (key >= '0' && key <= '9') || key == '.' || key == ',';
}

std::string PlanTool::hint() const {
    if (!fault_.empty()) return fault_;
    if (corners_.empty()) return tr("Click the first corner of the plan. Esc leaves");
    if (corners_.size() < 3)
        return tr("Click the next corner, or type the wall's length and press Enter. Shift: every 15°");
    return tr("Next corner, or Enter to close the plan. Backspace takes the last corner back");
}

/// On the raster; with Shift in a direction of the 15° fan from the last corner, its length on the raster;
/// of a typed length in the pointer's direction.
Vec2 PlanTool::aimed(const PaneSight& sight, const Vec2& pointer) const {
    const Vec2 free{snapped(pointer.x, sight.raster), snapped(pointer.y, sight.raster)};
    if (corners_.empty()) return free;
    const Vec2 from = corners_.back();
    const double typed = length_of(typed_);
    const bool fan = ImGui::GetIO().KeyShift;
    Vec2 way = (fan || typed > 0.0 ? pointer : free) - from;
    if (!(glm::length(way) > 1e-9)) return free;
    double angle = std::atan2(way.y, way.x);
    if (fan) angle = std::round(angle / turn_step) * turn_step;
    if (!fan && !(typed > 0.0)) return free;
    // Somebody who types a length along a raster direction means that direction.
    if (!fan)
        angle = std::abs(std::remainder(angle, turn_step)) < 0.06 ? std::round(angle / turn_step) * turn_step : angle;
    const Vec2 direction{std::cos(angle), std::sin(angle)};
    const double length = typed > 0.0 ? typed : snapped(glm::dot(way, direction), sight.raster);
    const Vec2 to = from + length * direction;
    return {std::round(to.x * 1e6) / 1e6, std::round(to.y * 1e6) / 1e6};
}

void PlanTool::read_typing() {
    for (const ImWchar letter : ImGui::GetIO().InputQueueCharacters) {
        const bool digit = letter >= '0' && letter <= '9';
        const bool point = (letter == '.' || letter == ',') && typed_.find('.') == std::string::npos;
        if ((digit || point) && !corners_.empty() && typed_.size() < 9)
            typed_ += point ? '.' : static_cast<char>(letter);
    }
    if (!pressed(Key::backspace)) return;
    fault_.clear();
    if (!typed_.empty())
        typed_.pop_back();
    else if (!corners_.empty())
        corners_.pop_back();
}

bool PlanTool::on_first(const PaneSight& sight) const {
    if (corners_.size() < 3) return false;
    const auto first = sight.pane.on_screen(Vec3{corners_.front(), floor_});
    return first && distance(*first, ImGui::GetIO().MousePos) < closing * style::scale();
}

void PlanTool::add(const Vec2& corner) {
    typed_.clear();
    fault_.clear();
    if (!corners_.empty() && glm::distance(corners_.back(), corner) < 1e-6) return;
    std::vector<Vec2> line = corners_;
    line.push_back(corner);
    if (last_edge_crosses(line)) {
        fault_ = tr("This wall would cross or touch another; choose another corner.");
        return;
    }
    corners_ = std::move(line);
}

ViewTool::Outcome PlanTool::close(const Scene& scene) {
    Outcome outcome;
    PlanEdit drawn = with_plan(scene, corners_);
    if (!drawn.scene) {
        fault_ = tr(std::string_view(drawn.message));
        return outcome;
    }
    outcome.chosen = Selection(drawn.scene->room->id);
    outcome.scene = std::move(drawn.scene);
    outcome.step = "Draw plan";
    outcome.settles = true;
    outcome.finished = true;
    return outcome;
}

ViewTool::Outcome PlanTool::handle(const PaneSight& sight) {
    read_typing();
    const auto met = on_horizontal_plane(sight.pane.ray(ImGui::GetIO().MousePos), floor_, reach);
    if (sight.hovered && met) next_ = aimed(sight, Vec2(*met));
    const bool enter = pressed(Key::enter) || pressed(Key::keypad_enter);
    if (enter && length_of(typed_) > 0.0 && next_) {
        add(*next_);
        return {};
    }
    if (enter) return close(*sight.scene);
    if (!sight.hovered || !next_ || !ImGui::IsMouseClicked(ImGuiMouseButton_Left)) return {};
    const bool twice = ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left) && corners_.size() >= 3 &&
                       glm::distance(corners_.back(), *next_) < 0.5 * std::max(sight.raster, 0.05);
    if (on_first(sight) || twice) return close(*sight.scene);
    add(*next_);
    return {};
}

void PlanTool::draw(const PaneSight& sight, WidgetRegistry& widgets) const {
    const auto at = [&](const Vec2& corner) { return Vec3{corner, floor_}; };
    std::vector<Vec3> line;
    for (const Vec2& corner : corners_) line.push_back(at(corner));
    sketch::line(sight.pane, line, style::accent, 2.5F);
    const auto measure = [&](const Vec2& from, const Vec2& to, const std::string& text, ImU32 colour) {
        if (const auto middle = sight.pane.on_screen(at(0.5 * (from + to)))) sketch::chip(*middle, text, colour);
    };
    for (std::size_t k = 0; k + 1 < corners_.size(); ++k)
        measure(corners_[k], corners_[k + 1], fmt::format("{:.2f} m", glm::distance(corners_[k], corners_[k + 1])),
                style::text);
    if (next_ && !corners_.empty()) {
        const Vec2 from = corners_.back();
        sketch::line(sight.pane, {at(from), at(*next_)}, fault_.empty() ? style::text : style::warning, 1.5F);
        if (corners_.size() > 1)
            sketch::line(sight.pane, {at(*next_), at(corners_.front())}, sketch::faint(style::quiet_text, 0.6F), 1.0F);
        const Vec2 way = *next_ - from;
        const double degrees = std::atan2(way.y, way.x) * 180.0 / std::numbers::pi;
        if (glm::length(way) > 0.0)
            measure(from, *next_,
                    typed_.empty() ? fmt::format("{:.2f} m  {:.0f}°", glm::length(way), degrees)
                                   : fmt::format("{}| m", typed_),
                    style::accent);
    }
    for (std::size_t k = 0; k < corners_.size(); ++k) {
        const auto corner = sight.pane.on_screen(at(corners_[k]));
        if (!corner) continue;
        const bool closes = k == 0 && on_first(sight);
        sketch::dot(*corner, closes ? 7.0F : 4.0F, style::accent);
        if (sight.number == 0)
            widgets.note(fmt::format("plan.corner{}", k + 1),
                         {corner->x - 5.0F, corner->y - 5.0F, corner->x + 5.0F, corner->y + 5.0F});
    }
    if (next_ && sight.hovered)
        if (const auto tip = sight.pane.on_screen(at(*next_))) sketch::dot(*tip, 3.0F, style::text);
    if (fault_.empty() || sight.number != 0) return;
    const float width = ImGui::CalcTextSize(fault_.c_str()).x;
    const ImVec2 mouse = ImGui::GetIO().MousePos;
    const float x = std::clamp(mouse.x, sight.pane.left + 0.5F * width + 12.0F,
                               sight.pane.left + std::max(sight.pane.width, width + 25.0F) - 0.5F * width - 12.0F);
    sketch::chip({x, mouse.y + 30.0F * style::scale()}, fault_, style::warning);
}

}  // namespace hanei
