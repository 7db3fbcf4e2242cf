#include "ui/panels/photometry_plot.h"

#include "ui/panels/style.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace hanei {
namespace {

constexpr float curve_width = 2.0F;
constexpr float dash = 6.0F, dash_gap = 4.0F;
constexpr int ring_sides = 72;
constexpr double tick_deg = 30.0;

ImVec2 on_screen(Vec2 place) { return {static_cast<float>(place.x), static_cast<float>(place.y)}; }

/// Small letters about a point: 0 puts the text's left or top edge there, 1 its right or bottom edge.
void small_text(ImVec2 at, ImVec2 anchor, const std::string& text, ImU32 colour = style::quiet_text) {
    ImFont* font = style::fonts().small;
    const ImVec2 size = font->CalcTextSizeA(font->FontSize, 1e4F, 0.0F, text.c_str());
    ImGui::GetWindowDrawList()->AddText(font, font->FontSize,
                                        {std::floor(at.x - anchor.x * size.x), std::floor(at.y - anchor.y * size.y)},
                                        colour, text.c_str());
}

/// What lies under such a text, dimmed, so that it reads over a curve.
void small_ground(ImVec2 at, ImVec2 anchor, const std::string& text) {
    ImFont* font = style::fonts().small;
    const ImVec2 size = font->CalcTextSizeA(font->FontSize, 1e4F, 0.0F, text.c_str());
    const ImVec2 low{std::floor(at.x - anchor.x * size.x), std::floor(at.y - anchor.y * size.y)};
    ImGui::GetWindowDrawList()->AddRectFilled({low.x - 1.0F, low.y}, {low.x + size.x + 1.0F, low.y + size.y},
                                              style::card, 2.0F);
}

/// The plot's item: its corner, and the pointer when it is over it.
struct Canvas {
    ImVec2 corner, size;
    std::optional<Vec2> pointer;
};

Canvas begin_canvas(float height, WidgetRegistry& widgets) {
    Canvas canvas{ImGui::GetCursorScreenPos(), {ImGui::GetContentRegionAvail().x, height}, {}};
    ImGui::InvisibleButton("photometry.plot", canvas.size);
    widgets.note("photometry.plot");
    const ImVec2 mouse = ImGui::GetIO().MousePos;
    if (ImGui::IsItemHovered()) canvas.pointer = Vec2(static_cast<double>(mouse.x), static_cast<double>(mouse.y));
    return canvas;
}

double rounded_to_half(double degrees) { return std::round(2.0 * degrees) / 2.0; }

double full_value(const PlotRequest& request, double step) {
    return std::max(1.0, std::ceil(request.peak * request.factor / step - 1e-9)) * step;
}

double value_at(const PlaneCurve& curve, double gamma_deg) {
    const auto after = std::lower_bound(curve.points.begin(), curve.points.end(), gamma_deg,
                                        [](const CurvePoint& point, double gamma) { return point.gamma_deg < gamma; });
    return after == curve.points.end() ? 0.0 : after->candela;
}

void marker(ImVec2 at, const PlaneCurve& curve) {
    const float scale = style::scale();
    ImDrawList& list = *ImGui::GetWindowDrawList();
    list.AddCircleFilled(at, 4.5F * scale, style::ground);
    list.AddCircleFilled(at, 3.0F * scale, curve.colour);
}

void draw_rings(const PolarFrame& frame, double step, bool upward) {
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const double last = upward ? 180.0 : 90.0;
    const int rings = static_cast<int>(std::lround(frame.full / step));
    for (int ring = 1; ring <= rings; ++ring) {
        std::vector<ImVec2> places;
        for (int k = 0; k <= ring_sides; ++k) {
            const double gamma = last * (2.0 * k / ring_sides - 1.0);
            places.push_back(on_screen(frame.at(gamma, ring * step)));
        }
        list.AddPolyline(places.data(), static_cast<int>(places.size()), style::plot, ImDrawFlags_None, 1.0F);
    }
    for (double gamma = -last; gamma <= last; gamma += tick_deg) {
        const bool axis = std::fmod(gamma, 90.0) == 0.0;
        list.AddLine(on_screen(frame.centre), on_screen(frame.at(gamma, frame.full)),
                     axis ? style::plot_axis : style::plot);
    }
}

/// Rings are named along the horizontal, where most luminaires are dark; as many as find room.
void name_rings(const PolarFrame& frame, double step, bool upward) {
    const float scale = style::scale();
    const int rings = static_cast<int>(std::lround(frame.full / step));
    const double widest = 34.0 * static_cast<double>(scale);
    const int every = std::max(1, static_cast<int>(std::ceil(widest * rings / frame.radius)));
    for (int ring = every; ring <= rings; ring += every) {
        const ImVec2 at = on_screen(frame.at(90.0, ring * step));
        const ImVec2 place{at.x - (upward ? 3.0F * scale : 0.0F), at.y - 2.0F * scale};
        const ImVec2 anchor{upward ? 1.0F : 0.5F, 1.0F};
        if (upward) small_ground(place, anchor, figure_on_axis(ring * step));
        small_text(place, anchor, figure_on_axis(ring * step));
    }
    for (double gamma = upward ? -180.0 + tick_deg : -90.0; gamma <= (upward ? 180.0 : 90.0); gamma += tick_deg) {
        const PolarFrame outside{frame.centre, frame.radius + 5.0 * static_cast<double>(scale), 1.0};
        const ImVec2 at = on_screen(outside.at(gamma, 1.0));
        const Vec2 out = outside.at(gamma, 1.0) - outside.centre;
        const Vec2 unit = out / glm::length(out);
        const bool level = std::abs(gamma) == 90.0;
        const auto across = static_cast<float>(0.5 - 0.5 * unit.x);
        const auto down = level ? (upward ? 0.5F : 0.0F) : static_cast<float>(0.5 - 0.5 * unit.y);
        const ImVec2 place =
            level && !upward ? ImVec2(at.x - 5.0F * scale * (gamma > 0.0 ? 1.0F : -1.0F), at.y + 4.0F * scale) : at;
        small_text(place, {level && !upward ? (gamma > 0.0 ? 0.0F : 1.0F) : across, down},
                   fmt::format("{:g}°", std::abs(gamma)));
    }
}

}  // namespace

std::string figure_on_axis(double value) { return fmt::format("{:.6g}", value); }

void stroke(ImDrawList& list, const std::vector<ImVec2>& places, const PlaneCurve& look) {
    const float scale = style::scale();
    const float width = curve_width * scale;
    if (!look.dashed) {
        list.AddPolyline(places.data(), static_cast<int>(places.size()), look.colour, ImDrawFlags_None, width);
        return;
    }
    float walked = 0.0F;  // along the curve, from the beginning of the present dash
    std::vector<ImVec2> piece;
    const auto finish = [&] {
        if (piece.size() > 1)
            list.AddPolyline(piece.data(), static_cast<int>(piece.size()), look.colour, ImDrawFlags_None, width);
        piece.clear();
    };
    for (std::size_t k = 0; k + 1 < places.size(); ++k) {
        ImVec2 from = places[k];
        const ImVec2 to = places[k + 1];
        float left = std::hypot(to.x - from.x, to.y - from.y);
        while (left > 0.0F) {
            const bool drawn = walked < dash * scale;
            const float next = drawn ? dash * scale : (dash + dash_gap) * scale;
            const float part = std::min(left, next - walked);
            const ImVec2 end{from.x + (to.x - from.x) * part / left, from.y + (to.y - from.y) * part / left};
            if (drawn && piece.empty()) piece.push_back(from);
            if (drawn) piece.push_back(end);
            walked += part;
            left -= part;
            from = end;
            if (walked < next) continue;
            finish();
            if (!drawn) walked = 0.0F;
        }
    }
    finish();
}

HoveredGamma polar_plot(const PlotRequest& request, WidgetRegistry& widgets) {
    const float scale = style::scale();
    const float letters = style::fonts().small->FontSize;
    const float width = ImGui::GetContentRegionAvail().x;
    const float margin = letters + 8.0F * scale;
    const float side = request.upward ? 30.0F * scale : 27.0F * scale;
    const float radius = std::clamp(0.5F * width - side, 20.0F * scale, 150.0F * scale);
    const float height = (request.upward ? 2.0F : 1.0F) * radius + 2.0F * margin;
    const Canvas canvas = begin_canvas(height, widgets);
    const double step = ring_step(request.peak * request.factor);
    PolarFrame frame;
    frame.centre = {static_cast<double>(std::floor(canvas.corner.x + 0.5F * canvas.size.x)),
                    static_cast<double>(std::floor(canvas.corner.y + margin + (request.upward ? radius : 0.0F)))};
    frame.radius = static_cast<double>(radius);
    frame.full = full_value(request, step);
    draw_rings(frame, step, request.upward);
    ImDrawList& list = *ImGui::GetWindowDrawList();
    for (auto curve = request.curves.rbegin(); curve != request.curves.rend(); ++curve) {
        std::vector<ImVec2> places;
        for (const CurvePoint& point : curve->points) {
            if (std::abs(point.gamma_deg) > 90.0 && !request.upward) continue;
            places.push_back(on_screen(frame.at(point.gamma_deg, point.candela * request.factor)));
        }
        stroke(list, places, *curve);
    }
    name_rings(frame, step, request.upward);
    if (!canvas.pointer) return std::nullopt;
    double gamma = rounded_to_half(frame.gamma_deg(*canvas.pointer));
    if (!request.upward) gamma = std::clamp(gamma, -90.0, 90.0);
    list.AddLine(on_screen(frame.centre), on_screen(frame.at(gamma, frame.full)), style::quiet_text);
    for (const PlaneCurve& curve : request.curves) {
        marker(on_screen(frame.at(gamma, value_at(curve, gamma) * request.factor)), curve);
    }
    return gamma;
}

HoveredGamma cartesian_plot(const PlotRequest& request, WidgetRegistry& widgets) {
    const float scale = style::scale();
    const float letters = style::fonts().small->FontSize;
    const Canvas canvas = begin_canvas(176.0F * scale, widgets);
    const double last = request.upward ? 180.0 : 90.0;
    const double step = ring_step(request.peak * request.factor);
    const double full = full_value(request, step);
    const int lines = static_cast<int>(std::lround(full / step));
    float names = 0.0F;
    for (int k = 0; k <= lines; ++k) {
        const std::string text = figure_on_axis(k * step);
        names = std::max(names, style::fonts().small->CalcTextSizeA(letters, 1e4F, 0.0F, text.c_str()).x);
    }
    const ImVec2 low{std::floor(canvas.corner.x + names + 7.0F * scale), std::floor(canvas.corner.y + 0.6F * letters)};
    const ImVec2 high{std::floor(canvas.corner.x + canvas.size.x - 14.0F * scale),
                      std::floor(canvas.corner.y + canvas.size.y - letters - 8.0F * scale)};
    const auto place = [&](double gamma, double value) {
        return ImVec2(low.x + static_cast<float>((gamma + last) / (2.0 * last)) * (high.x - low.x),
                      high.y - static_cast<float>(value / full) * (high.y - low.y));
    };
    ImDrawList& list = *ImGui::GetWindowDrawList();
    for (int k = 0; k <= lines; ++k) {
        const float y = std::floor(place(0.0, k * step).y);
        list.AddLine({low.x, y}, {high.x, y}, k == 0 ? style::plot_axis : style::plot);
        small_text({low.x - 6.0F * scale, y}, {1.0F, 0.5F}, figure_on_axis(k * step));
    }
    for (double gamma = -last; gamma <= last; gamma += request.upward ? 2.0 * tick_deg : tick_deg) {
        const float x = std::floor(place(gamma, 0.0).x);
        list.AddLine({x, low.y}, {x, high.y}, gamma == 0.0 ? style::plot_axis : style::plot);
        small_text({x, high.y + 4.0F * scale}, {0.5F, 0.0F}, fmt::format("{:g}°", std::abs(gamma)));
    }
    for (auto curve = request.curves.rbegin(); curve != request.curves.rend(); ++curve) {
        std::vector<ImVec2> places;
        for (const CurvePoint& point : curve->points) {
            if (std::abs(point.gamma_deg) > last) continue;
            places.push_back(place(point.gamma_deg, point.candela * request.factor));
        }
        stroke(list, places, *curve);
    }
    if (!canvas.pointer) return std::nullopt;
    const double across = (canvas.pointer->x - static_cast<double>(low.x)) / static_cast<double>(high.x - low.x);
    const double gamma = rounded_to_half(last * (2.0 * std::clamp(across, 0.0, 1.0) - 1.0));
    const float x = place(gamma, 0.0).x;
    list.AddLine({x, low.y}, {x, high.y}, style::quiet_text);
    for (const PlaneCurve& curve : request.curves) marker(place(gamma, value_at(curve, gamma) * request.factor), curve);
    return gamma;
}

}  // namespace hanei
