#include "ui/panels/label_layer.h"

#include "engine/edit/edit.h"
#include "ui/panels/style.h"

#include <cmath>

namespace hanei {
namespace {

constexpr ImU32 ground = IM_COL32(250, 250, 250, 190), strong_ground = IM_COL32(250, 250, 250, 238);
constexpr ImU32 ink = IM_COL32(24, 26, 30, 255), chosen_ground = IM_COL32(0xF2, 0xB8, 0x4B, 0xF4);
constexpr ImU32 leader = IM_COL32(250, 250, 250, 230), leader_shade = IM_COL32(10, 12, 14, 170);

/// A small arrow under the least and over the greatest: told without colours.
void draw_mark(ImDrawList& list, const ValueLabel& label, ImVec2 middle, ImVec2 half) {
    if (label.kind != ValueLabel::Kind::least && label.kind != ValueLabel::Kind::greatest) return;
    const float way = label.kind == ValueLabel::Kind::least ? 1.0F : -1.0F;
    const float reach = 5.0F * style::scale();
    const ImVec2 foot{middle.x, middle.y + way * half.y};
    list.AddTriangleFilled({foot.x - reach, foot.y}, {foot.x + reach, foot.y}, {foot.x, foot.y + way * reach},
                           strong_ground);
}

}  // namespace

ViewOptions LabelLayer::options_of(const PaneSight& sight) const {
    ViewOptions look = state_.options;
    look.part = state_.panes.part(sight.number, look.part);
    const ObjectId chosen = sight.selection.primary();
    if (kind_of(*sight.scene, chosen) == ObjectKind::grid) {
        look.values = true;
        look.values_of = chosen;
    }
    return difference ? as_difference(std::move(look), *difference) : look;
}

void LabelLayer::draw(const PaneSight& sight, WidgetRegistry& widgets) {
    if (!sight.answer) return;
    const ViewOptions look = options_of(sight);
    const Pane& pane = sight.pane;
    const PixelSize size{static_cast<int>(pane.width), static_cast<int>(pane.height)};
    Kept& kept = kept_[sight.number];
    const bool same = kept.solution == sight.answer && kept.options == look && kept.size == size;
    if (!same || kept.camera != pane.camera)
        kept = {value_labels(*sight.answer, pane.camera, look, size, static_cast<double>(style::scale())), sight.answer,
                pane.camera, look, size};
    ImDrawList& list = *ImGui::GetWindowDrawList();
    ImFont* const font = style::fonts().small;
    const auto on_screen = [&](const Vec2& at) {
        return ImVec2(std::floor(pane.left + static_cast<float>(at.x) * pane.width),
                      std::floor(pane.top + static_cast<float>(at.y) * pane.height));
    };
    for (const ValueLabel& label : kept.labels) {
        const ImVec2 middle = on_screen(label.at), of = on_screen(label.place);
        const ImVec2 text = font->CalcTextSizeA(font->FontSize, 1e4F, 0.0F, label.text.c_str());
        const ImVec2 half{0.5F * text.x + 4.0F * style::scale(), 0.5F * text.y + 1.0F};
        const bool is_point = label.kind == ValueLabel::Kind::point;
        if (is_point) {
            list.AddLine(of, middle, leader_shade, 3.0F * style::scale());
            list.AddLine(of, middle, leader, 1.3F * style::scale());
            list.AddCircleFilled(of, 4.6F * style::scale(), leader_shade);
            list.AddCircleFilled(of, 3.2F * style::scale(), leader);
        }
        draw_mark(list, label, middle, half);
        const ImU32 under = is_point && sight.selection.holds(label.object) ? chosen_ground
                            : label.kind == ValueLabel::Kind::figure        ? ground
                                                                            : strong_ground;
        list.AddRectFilled({middle.x - half.x, middle.y - half.y}, {middle.x + half.x, middle.y + half.y}, under,
                           3.0F * style::scale());
        list.AddText(font, font->FontSize, {middle.x - 0.5F * text.x, middle.y - 0.5F * text.y}, ink,
                     label.text.c_str());
        if (is_point && sight.number == 0)
            widgets.note("pin." + display_name(*sight.scene, label.object),
                         {middle.x - half.x, middle.y - half.y, middle.x + half.x, middle.y + half.y});
    }
}

}  // namespace hanei
