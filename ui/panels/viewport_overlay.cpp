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

void Viewport::draw_handles(const Input& input, const Pane& pane, WidgetRegistry& widgets) {
    const std::optional<HandleSight> sight = handles_of(input, pane);
    if (!sight) return;
    const std::optional<Grip> held = drag_ ? std::optional(drag_->gesture.grip()) : std::nullopt;
    const std::optional<Grip> lit = held ? held : handle_at(*sight, ImGui::GetIO().MousePos);
    hanei::draw_handles(*sight, held, lit, &pane == &state.panes.pane(0) ? &widgets : nullptr);
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
