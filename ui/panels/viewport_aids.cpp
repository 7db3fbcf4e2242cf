#include "ui/panels/form.h"
#include "ui/panels/language.h"
#include "ui/panels/sketch.h"
#include "ui/panels/style.h"
#include "ui/panels/units.h"
#include "ui/panels/viewport.h"
#include "ui/panels/wall_distances.h"
#include "ui/view/axis_cross.h"
#include "ui/view/scale_bar.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>

namespace hanei {
namespace {

// Pixels at scale 1.
constexpr float full_arm = 27.0F, small_arm = 20.0F, ball = 8.5F, margin = 16.0F;
constexpr float legend_height = 384.0F;  // that the colour scale takes at most, from the top
constexpr float legend_least = 214.0F;   // of the picture: below it there is none
constexpr float least_width = 250.0F, least_height = 180.0F;
constexpr float roomy = 400.0F;  // wide; smaller pictures have a smaller cross and a shorter bar
constexpr double longest_bar = 130.0, short_bar = 80.0;

/// From where an arm's end is looked at.
Standpoint standpoint_at(int axis, bool ahead) {
    constexpr std::array ends{Standpoint::right, Standpoint::left, Standpoint::back,
                              Standpoint::front, Standpoint::plan, Standpoint::ceiling_plan};
    return ends[static_cast<std::size_t>(2 * axis + (ahead ? 0 : 1))];
}

LengthUnit length_unit() {
    const std::string_view shown = shown_unit("m").label;
    return shown == "cm"   ? LengthUnit::centimetre
           : shown == "mm" ? LengthUnit::millimetre
           : shown == "ft" ? LengthUnit::feet_inches
                           : LengthUnit::metre;
}

ImU32 colour_of_axis(int axis) { return axis == 0 ? style::axis_x : axis == 1 ? style::axis_y : style::axis_z; }

void letter(ImDrawList& list, ImVec2 middle, char which, ImU32 colour) {
    const char text[] = {which, '\0'};
    ImFont* const font = style::fonts().small;
    const ImVec2 size = font->CalcTextSizeA(font->FontSize, 1e4F, 0.0F, text);
    list.AddText(font, font->FontSize, {std::round(middle.x - 0.5F * size.x), std::round(middle.y - 0.5F * size.y)},
                 colour, text);
}

/// Returns the end that is clicked.
std::optional<AxisMark> axis_cross(const Camera& camera, ImVec2 middle, float arm, const std::string& id,
                                   WidgetRegistry* widgets) {
    std::optional<AxisMark> clicked;
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const float scale = style::scale(), radius = ball * scale;
    list.AddCircleFilled(middle, (arm + ball + 5.0F) * scale, style::faded(style::card, 0.55F));
    const std::array<AxisMark, 6> marks = axis_marks(camera);
    const ImU32 letters = style::theme() == Theme::dark ? IM_COL32(16, 18, 22, 255) : IM_COL32_WHITE;
    const AxisMark* under = nullptr;
    std::array<ImVec2, 6> ends;
    for (std::size_t k = 0; k < marks.size(); ++k) {
        const AxisMark& mark = marks[k];
        ends[k] = {middle.x + arm * scale * static_cast<float>(mark.at.x),
                   middle.y + arm * scale * static_cast<float>(mark.at.y)};
        // The nearer of two ends that lie over each other is meant: the later one, as drawn.
        const ImVec2 mouse = ImGui::GetIO().MousePos;
        if (std::hypot(ends[k].x - mouse.x, ends[k].y - mouse.y) <= radius) under = &mark;
    }
    for (std::size_t k = 0; k < marks.size(); ++k) {
        const AxisMark& mark = marks[k];
        const ImVec2 at = ends[k];
        const ImU32 colour = colour_of_axis(mark.axis);
        const bool lit = under == &mark && ImGui::IsWindowHovered(ImGuiHoveredFlags_AllowWhenBlockedByActiveItem);
        if (mark.ahead) list.AddLine(middle, at, style::faded(colour, 0.85F), 2.0F * scale);
        list.AddCircleFilled(at, radius, mark.ahead ? colour : ImU32(style::card));
        if (!mark.ahead) list.AddCircle(at, radius - 0.5F * scale, style::faded(colour, 0.8F), 0, 1.3F * scale);
        if (lit) list.AddCircle(at, radius + 1.5F * scale, style::text, 0, 1.5F * scale);
        if (mark.ahead) letter(list, at, mark.letter(), letters);
        const std::string name = fmt::format("axis.{}{}", mark.ahead ? "" : "-", mark.letter());
        if (widgets != nullptr) widgets->note(name, {at.x - radius, at.y - radius, at.x + radius, at.y + radius});
    }
    if (under == nullptr) return clicked;
    ImGui::SetCursorScreenPos({ImGui::GetIO().MousePos.x - radius, ImGui::GetIO().MousePos.y - radius});
    if (ImGui::InvisibleButton(id.c_str(), {2.0F * radius, 2.0F * radius})) clicked = *under;
    const Standpoint standpoint = standpoint_at(under->axis, under->ahead);
    tooltip(fmt::format("{} ({}{})", tr(name_of(standpoint)), under->ahead ? "+" : "-",
                        static_cast<char>('x' + under->axis)));
    return clicked;
}

struct WithFont {
    explicit WithFont(ImFont* font) { ImGui::PushFont(font); }
    ~WithFont() { ImGui::PopFont(); }
    WithFont(const WithFont&) = delete;
    WithFont& operator=(const WithFont&) = delete;
};

void draw_scale_bar(const Pane& pane, const ScaleBar& bar) {
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const float scale = style::scale();
    ImFont* const font = style::fonts().small;
    const float thick = std::round(5.0F * scale), length = static_cast<float>(bar.pixels);
    const ImVec2 text = font->CalcTextSizeA(font->FontSize, 1e4F, 0.0F, bar.text.c_str());
    // Above the line in which the light under the pointer is read.
    const float left = std::round(pane.left + 20.0F * scale);
    const float top = std::round(pane.top + pane.height - 52.0F * scale);
    const float right = left + length + 10.0F * scale + text.x;
    list.AddRectFilled({left - 8.0F * scale, top - 0.5F * text.y - 1.0F * scale},
                       {right + 8.0F * scale, top + thick + 0.5F * text.y + 1.0F * scale}, style::card, 5.0F * scale);
    const float field = length / static_cast<float>(bar.fields);
    for (int k = 0; k < bar.fields; ++k) {
        const float from = left + field * static_cast<float>(k);
        if (k % 2 == 0) list.AddRectFilled({from, top}, {from + field, top + thick}, style::text);
    }
    list.AddRect({left, top}, {left + length, top + thick}, style::text, 0.0F, ImDrawFlags_None, style::hairline());
    list.AddText(font, font->FontSize, {left + length + 10.0F * scale, std::round(top + 0.5F * (thick - text.y))},
                 style::text, bar.text.c_str());
}

/// With strokes across both ends. Words keep clear of what stands right of the edge.
void draw_distance(const Pane& pane, const WallDistance& distance, float right_edge) {
    const auto a = pane.on_screen(distance.from), b = pane.on_screen(distance.to);
    if (!a || !b) return;
    const float length = std::hypot(b->x - a->x, b->y - a->y), scale = style::scale();
    sketch::line(pane, {distance.from, distance.to}, style::sight, 1.2F);
    const ImVec2 across{4.0F * scale * (b->y - a->y) / std::max(1.0F, length),
                        4.0F * scale * (a->x - b->x) / std::max(1.0F, length)};
    for (const ImVec2& end : {*a, *b})
        ImGui::GetWindowDrawList()->AddLine({end.x - across.x, end.y - across.y}, {end.x + across.x, end.y + across.y},
                                            style::sight, 1.4F * scale);
    const std::string text = with_unit(distance.metres(), "m", 2);
    const WithFont small(style::fonts().small);
    const ImVec2 room = ImGui::CalcTextSize(text.c_str());
    const float needed = distance.axis == 0 ? room.x + 16.0F * scale : room.y + 10.0F * scale;
    if (length > needed) return sketch::chip({0.5F * (a->x + b->x), 0.5F * (a->y + b->y)}, text, style::text);
    // Beyond the wall, where there is more room than between; beside the line where the picture ends there.
    const float beyond = 0.5F * needed + 3.0F * scale, along = std::max(1.0F, length);
    ImVec2 middle{b->x + beyond * (b->x - a->x) / along, b->y + beyond * (b->y - a->y) / along};
    const ImVec2 half{0.5F * room.x + 9.0F * scale, 0.5F * room.y + 6.0F * scale};
    const bool has_room = middle.x - half.x >= pane.left && middle.x + half.x <= right_edge &&
                          middle.y - half.y >= pane.top && middle.y + half.y <= pane.top + pane.height;
    if (!has_room && distance.axis == 0) {
        middle.x =
            std::clamp(0.5F * (a->x + b->x), pane.left + half.x, std::max(pane.left + half.x, right_edge - half.x));
        middle.y = b->y + 2.0F * half.y;
    } else if (!has_room) {
        middle.x = b->x + 1.4F * half.x;
        middle.y = 0.5F * (a->y + b->y);
    }
    sketch::chip(middle, text, style::text);
}

}  // namespace

/// Axes and scale in the corners, and in plans how far what is chosen is from the walls.
void Viewport::draw_aids(const Input& input, int k, WidgetRegistry& widgets) {
    const Pane& pane = state.panes.pane(k);
    const float scale = style::scale();
    WidgetRegistry* const noted = k == state.panes.active() ? &widgets : nullptr;
    const std::optional<Standpoint> standpoint = standpoint_of(pane.camera);
    const bool is_plan = standpoint == Standpoint::plan || standpoint == Standpoint::ceiling_plan;
    if (state.distances && is_plan && !tool_) {
        const auto caught_along = [&](int axis) {
            if (!drag_) return false;
            const std::vector<SnapLine>& caught = drag_->gesture.caught();
            return std::any_of(caught.begin(), caught.end(), [&](const SnapLine& line) { return line.axis == axis; });
        };
        for (const WallDistance& distance : wall_distances(*input.scene, input.selection.ids()))
            if (!caught_along(distance.axis)) draw_distance(pane, distance, pane.left + pane.width - covered());
    }
    if (pane.width < least_width * scale || pane.height < least_height * scale) return;
    const bool is_roomy = pane.width >= roomy * scale;
    if (state.scale_bar) {
        const auto bar = scale_bar(pane.camera, static_cast<double>(pane.height),
                                   (is_roomy ? longest_bar : short_bar) * static_cast<double>(scale), length_unit());
        if (bar) draw_scale_bar(pane, *bar);
        const ImVec2 corner{pane.left + 20.0F * scale, pane.top + pane.height - 52.0F * scale};
        if (bar && noted != nullptr)
            widgets.note("scale_bar",
                         {corner.x, corner.y, corner.x + static_cast<float>(bar->pixels), corner.y + 5.0F * scale});
    }
    if (!state.axes) return;
    const float arm = is_roomy ? full_arm : small_arm, reach = (arm + ball) * scale;
    const ImVec2 low{pane.left + pane.width - margin * scale - reach, pane.top + pane.height - margin * scale - reach};
    const bool beside_legend = pane.height >= legend_least * scale && low.y - reach < pane.top + legend_height * scale;
    const std::optional<AxisMark> clicked = axis_cross(pane.camera, {low.x - (beside_legend ? covered() : 0.0F), low.y},
                                                       arm, fmt::format("axis {}", k), noted);
    if (!clicked) return;
    const Standpoint wished = standpoint_at(clicked->axis, clicked->ahead);
    state.panes.activate(k, state.present());
    const bool is_there = standpoint_of(state.camera) == wished;
    look_from(is_there ? standpoint_at(clicked->axis, !clicked->ahead) : wished, *input.scene);
}

}  // namespace hanei
