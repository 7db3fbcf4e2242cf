#include "engine/edit/edit.h"
#include "engine/scene/dimmers.h"
#include "ui/panels/language.h"
#include "ui/panels/style.h"
#include "ui/panels/viewport.h"

#include <array>
#include <cmath>
#include <fmt/format.h>

namespace hanei {
namespace {

constexpr float grip_radius = 10.0F;   // pixels around a handle's tip that take hold of it
constexpr double handle_share = 0.13;  // length of a handle, of the picture's height

constexpr std::array axes{Axis::x, Axis::y, Axis::z};
constexpr std::array axis_names{"handle.x", "handle.y", "handle.z"};
constexpr std::array axis_colours{style::axis_x, style::axis_y, style::axis_z};

void arrow(ImDrawList& list, ImVec2 from, ImVec2 to, ImU32 colour, float scale) {
    const float length = std::hypot(to.x - from.x, to.y - from.y);
    if (length < 6.0F * scale) return;  // seen end on
    const ImVec2 along{(to.x - from.x) / length, (to.y - from.y) / length};
    const ImVec2 neck{to.x - 11.0F * scale * along.x, to.y - 11.0F * scale * along.y};
    const ImVec2 side{-5.0F * scale * along.y, 5.0F * scale * along.x};
    const ImU32 shade = style::shade;
    list.AddLine(from, neck, shade, 4.5F * scale);
    list.AddLine(from, neck, colour, 2.5F * scale);
    list.AddTriangleFilled(to, {neck.x + side.x, neck.y + side.y}, {neck.x - side.x, neck.y - side.y}, colour);
}

/// Text on a dark ground, so that it reads over any picture.
void chip(ImVec2 at, const std::string& text, ImU32 colour) {
    const float scale = style::scale();
    const ImVec2 size = ImGui::CalcTextSize(text.c_str());
    ImDrawList& list = *ImGui::GetWindowDrawList();
    list.AddRectFilled({at.x - 8.0F * scale, at.y - 4.0F * scale},
                       {at.x + size.x + 8.0F * scale, at.y + size.y + 5.0F * scale}, style::card, 5.0F * scale);
    list.AddText(at, colour, text.c_str());
}

}  // namespace

void Viewport::draw_title(const Pane& pane, const std::string& text) const {
    const float scale = style::scale();
    chip({pane.left + 18.0F * scale, pane.top + 14.0F * scale}, text, style::text);
}

/// Places are found at rest, which takes as long as a picture; while something is dragged the figures
/// stay whose lines do.
void Viewport::draw_isolux_labels(const Input& input, const Pane& pane, int k) {
    const ViewOptions look = options_of(input, k);
    if (!look.isolux || look.values || look.scale == Scale::photo || !input.solution) return;
    Labels& kept = labels_[k];
    const PixelSize size{static_cast<int>(pane.width), static_cast<int>(pane.height)};
    const bool same_picture = kept.camera == pane.camera && kept.options == look && kept.size == size;
    if (moving() && !same_picture) return;
    if (moving() && kept.solution != input.solution) {
        kept.labels = labels_that_hold(kept.labels, *input.solution, pane.camera, look, size);
        kept.solution = input.solution;
        kept.thinned = true;
    } else if (!moving() && (kept.thinned || kept.solution != input.solution || !same_picture)) {
        kept = {isolux_labels(*input.solution, pane.camera, look, size, style::scale()),
                input.solution,
                pane.camera,
                look,
                size,
                false};
    }
    ImFont* font = style::fonts().small;
    ImDrawList& list = *ImGui::GetWindowDrawList();
    for (const IsoluxLabel& label : kept.labels) {
        const ImVec2 extent = font->CalcTextSizeA(font->FontSize, 1e4F, 0.0F, label.text.c_str());
        const ImVec2 at{std::floor(pane.left + static_cast<float>(label.at.x) * pane.width - 0.5F * extent.x),
                        std::floor(pane.top + static_cast<float>(label.at.y) * pane.height - 0.5F * extent.y)};
        list.AddRectFilled({at.x - 3.0F, at.y}, {at.x + extent.x + 3.0F, at.y + extent.y}, IM_COL32(250, 250, 250, 205),
                           3.0F);
        list.AddText(font, font->FontSize, at, IM_COL32(24, 26, 30, 255), label.text.c_str());
    }
}

double Viewport::handle_length(const Pane& pane, const Vec3& place) const {
    return handle_share * picture_height_at(pane.camera, place);
}

std::optional<Axis> Viewport::handle_under(const Input& input, const Pane& pane, ImVec2 at) const {
    const std::optional<Vec3> place = place_of(*input.scene, input.selection.primary());
    if (!place) return std::nullopt;
    const auto origin = pane.on_screen(*place);
    for (const Axis axis : axes) {
        const auto tip = pane.on_screen(*place + handle_length(pane, *place) * direction_of(axis));
        const bool end_on = tip && origin && std::hypot(tip->x - origin->x, tip->y - origin->y) < 6.0F * style::scale();
        if (end_on) continue;  // not drawn either
        if (tip && std::hypot(tip->x - at.x, tip->y - at.y) < grip_radius * style::scale()) return axis;
    }
    return std::nullopt;
}

void Viewport::draw_handles(const Input& input, const Pane& pane, WidgetRegistry& widgets) {
    const std::optional<Vec3> place = place_of(*input.scene, input.selection.primary());
    const std::optional<ImVec2> origin = place ? pane.on_screen(*place) : std::nullopt;
    if (!origin) return;
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const float scale = style::scale();
    const ImVec2 mouse = ImGui::GetIO().MousePos;
    const std::optional<Axis> under = drag_ ? drag_->gesture.axis : handle_under(input, pane, mouse);
    for (std::size_t k = 0; k < axes.size(); ++k) {
        const auto tip = pane.on_screen(*place + handle_length(pane, *place) * direction_of(axes[k]));
        if (!tip || (drag_ && drag_->gesture.axis && drag_->gesture.axis != axes[k])) continue;
        arrow(list, *origin, *tip, under == axes[k] ? style::accent : axis_colours[k], scale);
        if (&pane != &state.panes.pane(0)) continue;
        const float reach = 5.0F * scale;
        widgets.note(axis_names[k], {tip->x - reach, tip->y - reach, tip->x + reach, tip->y + reach});
    }
    list.AddCircleFilled(*origin, 5.0F * scale, style::shade);
    list.AddCircleFilled(*origin, 3.5F * scale, style::accent);
    if (!drag_ || !drag_->begun) return;
    const Vec3 by = drag_->last - drag_->gesture.start;
    const std::string text = drag_->gesture.axis == Axis::z ? fmt::format("z {:.2f} m  ({:+.2f})", drag_->last.z, by.z)
                                                            : fmt::format("{:+.2f}  {:+.2f} m", by.x, by.y);
    chip({origin->x - 0.5F * ImGui::CalcTextSize(text.c_str()).x, origin->y + 16.0F * scale}, text, style::text);
}

void Viewport::draw_readout(const Input& input, const ScreenRect& all) const {
    const float scale = style::scale();
    if (!holds_light(*input.scene)) {
        const std::string text = tr("No light yet: Ctrl+L adds a luminaire");
        return chip({all.left + 20.0F * scale, all.bottom - ImGui::GetTextLineHeight() - 17.0F * scale}, text,
                    style::quiet_text);
    }
    if (!probe_ || drag_) return;
    const std::string text = probe_->text() + (input.stale ? " · before the last change" : "");
    chip({all.left + 20.0F * scale, all.bottom - ImGui::GetTextLineHeight() - 17.0F * scale}, text,
         input.stale ? style::quiet_text : style::text);
}

}  // namespace hanei
