#include "ui/panels/handles.h"

#include "ui/panels/language.h"
#include "ui/panels/style.h"
#include "ui/panels/units.h"

#include <array>
#include <cmath>
#include <fmt/format.h>
#include <numbers>

namespace hanei {
namespace {

constexpr float grip_radius = 10.0F;  // pixels around a handle's mark that take hold of it
constexpr double arrow_share = 0.13;  // lengths, of the picture's height
constexpr double square_share = 0.045;
constexpr double ring_share = 0.1;
constexpr int ring_sides = 64;
constexpr float near_reach = 1.25F;   // lengths of an arrow around the middle: where rings and squares are shown
constexpr float shown_share = 0.55F;  // of the opacity of handles that are not pointed at

struct Mark {
    Grip grip;
    const char* name;
    ImU32 colour;
};

std::array<Mark, 8> marks() {
    return {Mark{Grip::x, "handle.x", style::axis_x},
            Mark{Grip::y, "handle.y", style::axis_y},
            Mark{Grip::z, "handle.z", style::axis_z},
            Mark{Grip::plane_xy, "handle.plane", style::axis_z},
            Mark{Grip::plane_xz, "handle.plane_xz", style::axis_y},
            Mark{Grip::plane_yz, "handle.plane_yz", style::axis_x},
            Mark{Grip::turn, "handle.rotate", style::axis_z},
            Mark{Grip::tilt, "handle.tilt", style::accent}};
}

bool is_arrow(Grip grip) { return grip == Grip::x || grip == Grip::y || grip == Grip::z; }
bool is_ring(Grip grip) { return grip == Grip::turn || grip == Grip::tilt; }

/// Which way the mark of a handle lies, in lengths of an arrow.
Vec3 offset_of(Grip grip, const HandleSight& sight) {
    const double square = square_share / arrow_share, ring = ring_share / arrow_share;
    switch (grip) {
        case Grip::x:
            return {1.0, 0.0, 0.0};
        case Grip::y:
            return {0.0, 1.0, 0.0};
        case Grip::z:
            return {0.0, 0.0, 1.0};
        case Grip::plane_xy:
            return {square, square, 0.0};
        case Grip::plane_xz:
            return {square, 0.0, square};
        case Grip::plane_yz:
            return {0.0, square, square};
        case Grip::turn:
            return {-ring * std::numbers::sqrt2 / 2.0, -ring * std::numbers::sqrt2 / 2.0, 0.0};
        case Grip::tilt: {
            const double slant = 0.25 * std::numbers::pi;
            return ring *
                   Vec3{std::cos(sight.yaw) * std::sin(slant), std::sin(sight.yaw) * std::sin(slant), -std::cos(slant)};
        }
    }
    return {};
}

double length_of_arrow(const HandleSight& sight) {
    return arrow_share * picture_height_at(sight.pane.camera, sight.place);
}

std::optional<ImVec2> mark_on_screen(Grip grip, const HandleSight& sight) {
    if (grip == Grip::tilt && !sight.tilts) return std::nullopt;
    return sight.pane.on_screen(sight.place + length_of_arrow(sight) * offset_of(grip, sight));
}

void arrow(ImDrawList& list, ImVec2 from, ImVec2 to, ImU32 colour, float scale) {
    const float length = std::hypot(to.x - from.x, to.y - from.y);
    if (length < 6.0F * scale) return;  // seen end on
    const ImVec2 along{(to.x - from.x) / length, (to.y - from.y) / length};
    const ImVec2 neck{to.x - 11.0F * scale * along.x, to.y - 11.0F * scale * along.y};
    const ImVec2 side{-5.0F * scale * along.y, 5.0F * scale * along.x};
    list.AddLine(from, neck, style::shade, 4.0F * scale);
    list.AddLine(from, neck, colour, 2.0F * scale);
    list.AddTriangleFilled(to, {neck.x + side.x, neck.y + side.y}, {neck.x - side.x, neck.y - side.y}, colour);
}

/// A square between two arrows: it moves in their plane.
void square(ImDrawList& list, Grip grip, const HandleSight& sight, ImU32 colour) {
    const Vec3 whole = length_of_arrow(sight) * offset_of(grip, sight);
    constexpr double inner = 0.55;
    std::array<ImVec2, 4> corners;
    for (int k = 0; k < 4; ++k) {
        Vec3 at = whole;
        bool second = false;
        for (int axis = 0; axis < 3; ++axis) {
            if (whole[axis] == 0.0) continue;
            const bool near = second ? k == 0 || k == 1 : k == 0 || k == 3;
            at[axis] *= near ? inner : 1.0 + (1.0 - inner);
            second = true;
        }
        const auto seen = sight.pane.on_screen(sight.place + at);
        if (!seen) return;
        corners[static_cast<std::size_t>(k)] = *seen;
    }
    list.AddConvexPolyFilled(corners.data(), 4, style::faded(colour, 0.4F));
    list.AddPolyline(corners.data(), 4, colour, ImDrawFlags_Closed, style::scale());
}

void ring(ImDrawList& list, Grip grip, const HandleSight& sight, ImU32 colour, ImVec2 knob) {
    const float scale = style::scale();
    const double radius = ring_share / arrow_share * length_of_arrow(sight);
    const Vec3 c0{std::cos(sight.yaw), std::sin(sight.yaw), 0.0};
    std::vector<Vec3> places;
    for (int k = 0; k <= ring_sides; ++k) {
        const double angle = 2.0 * std::numbers::pi * k / ring_sides;
        const Vec3 up = grip == Grip::turn ? Vec3{0.0, 1.0, 0.0} : Vec3{0.0, 0.0, 1.0};
        const Vec3 along = grip == Grip::turn ? Vec3{1.0, 0.0, 0.0} : c0;
        places.push_back(sight.place + radius * (std::cos(angle) * along + std::sin(angle) * up));
    }
    for (const std::vector<ImVec2>& run : sight.pane.on_screen(places)) {
        if (run.size() < 2) continue;
        const int count = static_cast<int>(run.size());
        list.AddPolyline(run.data(), count, colour, ImDrawFlags_None, 1.2F * scale);
    }
    list.AddCircleFilled(knob, 5.5F * scale, style::shade);
    list.AddCircleFilled(knob, 4.0F * scale, colour | IM_COL32_A_MASK);
}

void chip(ImVec2 middle, const std::string& text, ImU32 colour, ImFont* font) {
    const float scale = style::scale();
    const ImVec2 size = font->CalcTextSizeA(font->FontSize, 1e4F, 0.0F, text.c_str());
    const ImVec2 at{std::floor(middle.x - 0.5F * size.x), std::floor(middle.y - 0.5F * size.y)};
    ImDrawList& list = *ImGui::GetWindowDrawList();
    list.AddRectFilled({at.x - 6.0F * scale, at.y - 2.0F * scale},
                       {at.x + size.x + 6.0F * scale, at.y + size.y + 3.0F * scale}, style::card, 4.0F * scale);
    list.AddText(font, font->FontSize, at, colour, text.c_str());
}

/// Rings and squares come with the pointer: away from what is chosen the arrows alone are calm to look at.
bool is_near(const HandleSight& sight, ImVec2 origin, ImVec2 at) {
    const float length = static_cast<float>(arrow_share) * sight.pane.height;
    return std::hypot(at.x - origin.x, at.y - origin.y) < near_reach * length;
}

}  // namespace

std::optional<Grip> handle_at(const HandleSight& sight, ImVec2 at) {
    std::optional<Grip> nearest;
    float least = grip_radius * style::scale();
    const auto origin = sight.pane.on_screen(sight.place);
    for (const Mark& mark : marks()) {
        const auto seen = mark_on_screen(mark.grip, sight);
        const bool end_on = seen && origin && is_arrow(mark.grip) &&
                            std::hypot(seen->x - origin->x, seen->y - origin->y) < 6.0F * style::scale();
        if (end_on) continue;  // not drawn either
        const float away = seen ? std::hypot(seen->x - at.x, seen->y - at.y) : least;
        if (away >= least) continue;
        least = away;
        nearest = mark.grip;
    }
    return nearest;
}

void draw_handles(const HandleSight& sight, std::optional<Grip> held, std::optional<Grip> lit,
                  WidgetRegistry* widgets) {
    const std::optional<ImVec2> origin = sight.pane.on_screen(sight.place);
    if (!origin) return;
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const float scale = style::scale();
    const bool near = is_near(sight, *origin, ImGui::GetIO().MousePos);
    for (const Mark& mark : marks()) {
        const auto seen = mark_on_screen(mark.grip, sight);
        if (!seen || (held && *held != mark.grip)) continue;
        const float reach = 5.0F * scale;
        if (widgets != nullptr)
            widgets->note(mark.name, {seen->x - reach, seen->y - reach, seen->x + reach, seen->y + reach});
        if (!held && !near && !is_arrow(mark.grip)) continue;
        const bool pointed = lit == mark.grip;
        const ImU32 colour = pointed                       ? ImU32(style::accent)
                             : is_arrow(mark.grip) || held ? mark.colour
                                                           : style::faded(mark.colour, shown_share);
        if (is_arrow(mark.grip))
            arrow(list, *origin, *seen, colour, scale);
        else if (is_ring(mark.grip))
            ring(list, mark.grip, sight, colour, *seen);
        else
            square(list, mark.grip, sight, colour);
    }
    list.AddCircleFilled(*origin, 5.0F * scale, style::shade);
    list.AddCircleFilled(*origin, 3.5F * scale, style::accent);
}

void draw_guides(const Pane& pane, const ObjectDrag& drag) {
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const float scale = style::scale();
    const Vec3 place = drag.place();
    for (const SnapLine& line : drag.caught()) {
        Vec3 from = place;
        const bool across = line.kind == SnapKind::wall || line.kind == SnapKind::half_spacing;
        if (across)
            from[line.axis] = line.source;
        else if (line.kind == SnapKind::object)
            from[1 - line.axis] = line.source;
        Vec3 to = place;
        constexpr double either_way = 0.6;  // m: a centre line is a stroke through what is moved
        if (line.kind == SnapKind::centre) {
            from[1 - line.axis] -= either_way;
            to[1 - line.axis] += either_way;
        }
        const auto a = pane.on_screen(from), b = pane.on_screen(to);
        if (!a || !b) continue;
        list.AddLine(*a, *b, style::shade, 2.6F * scale);
        list.AddLine(*a, *b, style::accent, 1.2F * scale);
        const double length = glm::length(to - from);
        const std::string text = line.kind == SnapKind::centre ? std::string(tr("centre")) : with_unit(length, "m", 2);
        if (length > 0.05)
            chip({0.5F * (a->x + b->x), 0.5F * (a->y + b->y)}, text, style::accent, style::fonts().small);
    }
    const std::optional<ImVec2> origin = pane.on_screen(place);
    if (!origin) return;
    chip({origin->x, origin->y + 26.0F * scale}, drag.readout(), style::text, style::fonts().regular);
    const std::string fault = drag.fault();
    if (!fault.empty()) chip({origin->x, origin->y + 50.0F * scale}, fault, style::warning, style::fonts().small);
}

}  // namespace hanei
