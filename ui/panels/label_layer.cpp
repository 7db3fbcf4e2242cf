#include "ui/panels/label_layer.h"

#include "engine/edit/edit.h"
#include "engine/edit/several.h"
#include "ui/panels/pin_tool.h"
#include "ui/panels/style.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>

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

bool overlap(const ScreenRect& a, const ScreenRect& b) {
    return a.left < b.right && b.left < a.right && a.top < b.bottom && b.top < a.bottom;
}

ScreenRect around(ImVec2 middle, ImVec2 half) {
    return {middle.x - half.x, middle.y - half.y, middle.x + half.x, middle.y + half.y};
}

/// The middle of a chosen pin's label: beside its handles, on the side from which arrows point away and
/// where no other label stands.
ImVec2 clear_of_arrows(const Pane& pane, const Vec3& place, ImVec2 of, ImVec2 half,
                       std::span<const ScreenRect> others) {
    constexpr float over_another = 1.0F;  // as bad as an arrow
    const float distance = 46.0F * style::scale();
    constexpr double length = 0.1;  // of the picture's height
    constexpr int sides = 8;
    const double reach = length * picture_height_at(pane.camera, place);
    ImVec2 best = of;
    float least = 1e9F;
    for (int side = 0; side < sides; ++side) {
        const double angle = 2.0 * std::numbers::pi * side / sides;
        const ImVec2 way{static_cast<float>(std::cos(angle)), static_cast<float>(std::sin(angle))};
        const ImVec2 middle{std::floor(of.x + way.x * (distance + half.x)), std::floor(of.y + way.y * distance)};
        const ScreenRect rect = around(middle, half);
        const bool covers =
            std::any_of(others.begin(), others.end(), [&](const ScreenRect& other) { return overlap(rect, other); });
        float nearness = covers ? over_another : 0.0F;
        for (const Axis axis : {Axis::x, Axis::y, Axis::z}) {
            const auto tip = pane.on_screen(place + reach * direction_of(axis));
            if (!tip) continue;
            const float away = std::max(1.0F, std::hypot(tip->x - of.x, tip->y - of.y));
            nearness = std::max(
                nearness, (covers ? over_another : 0.0F) + (way.x * (tip->x - of.x) + way.y * (tip->y - of.y)) / away);
        }
        if (nearness >= least) continue;
        least = nearness;
        best = middle;
    }
    return best;
}

const CalculationPoint* pin_of(const Scene& scene, ObjectId id) {
    for (const CalculationPoint& point : scene.points)
        if (point.id == id) return &point;
    return nullptr;
}

/// Where handles.h writes how far a drag has gone.
std::optional<ScreenRect> readout_of(const Pane& pane, const std::optional<Vec3>& dragged) {
    const auto at = dragged ? pane.on_screen(*dragged) : std::nullopt;
    if (!at) return std::nullopt;
    const float scale = style::scale();
    return ScreenRect{at->x - 110.0F * scale, at->y + 12.0F * scale, at->x + 110.0F * scale, at->y + 62.0F * scale};
}

bool is_within(const ScreenRect& rect, ImVec2 at) {
    return at.x >= rect.left && at.x < rect.right && at.y >= rect.top && at.y < rect.bottom;
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
    std::vector<Pin>& pins = pins_[sight.number];
    pins.clear();
    const std::optional<ScreenRect> readout = readout_of(pane, dragged);
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
    std::vector<ScreenRect> drawn;
    const auto draw_label = [&](const ValueLabel& label, bool chosen) {
        ImVec2 middle = on_screen(label.at);
        const ImVec2 of = on_screen(label.place);
        const ImVec2 text = font->CalcTextSizeA(font->FontSize, 1e4F, 0.0F, label.text.c_str());
        const ImVec2 half{0.5F * text.x + 4.0F * style::scale(), 0.5F * text.y + 1.0F};
        const bool is_point = label.kind == ValueLabel::Kind::point;
        if (chosen) middle = clear_of_arrows(pane, pin_of(*sight.scene, label.object)->position, of, half, drawn);
        const ScreenRect rect = around(middle, half);
        if (readout && overlap(rect, *readout)) return;
        drawn.push_back(rect);
        if (is_point) {
            list.AddLine(of, middle, leader_shade, 3.0F * style::scale());
            list.AddLine(of, middle, leader, 1.3F * style::scale());
            list.AddCircleFilled(of, 4.6F * style::scale(), leader_shade);
            list.AddCircleFilled(of, 3.2F * style::scale(), leader);
        }
        draw_mark(list, label, middle, half);
        const ImU32 under = chosen ? chosen_ground : label.kind == ValueLabel::Kind::figure ? ground : strong_ground;
        list.AddRectFilled({rect.left, rect.top}, {rect.right, rect.bottom}, under, 3.0F * style::scale());
        list.AddText(font, font->FontSize, {middle.x - 0.5F * text.x, middle.y - 0.5F * text.y}, ink,
                     label.text.c_str());
        if (!is_point) return;
        pins.push_back({label.object, rect});
        if (sight.number == 0) widgets.note("pin." + display_name(*sight.scene, label.object), rect);
    };
    const auto is_chosen = [&](const ValueLabel& label) {
        return label.kind == ValueLabel::Kind::point && sight.selection.holds(label.object) &&
               pin_of(*sight.scene, label.object) != nullptr;
    };
    for (const ValueLabel& label : kept.labels)
        if (!is_chosen(label)) draw_label(label, false);
    for (const ValueLabel& label : kept.labels)
        if (is_chosen(label)) draw_label(label, true);
}

std::unique_ptr<ViewTool> LabelLayer::take(const PaneSight& sight) {
    if (others != nullptr)
        if (std::unique_ptr<ViewTool> taken = others->take(sight)) return taken;
    const ImVec2 mouse = ImGui::GetIO().MousePos;
    const std::vector<Pin>& pins = pins_[sight.number];
    const auto found =
        std::find_if(pins.rbegin(), pins.rend(), [&](const Pin& pin) { return is_within(pin.label, mouse); });
    if (found == pins.rend() || pin_of(*sight.scene, found->id) == nullptr) return nullptr;
    const auto handles = middle_of(*sight.scene, sight.selection.ids());
    const bool on_handle = handles && handle_at({sight.pane, *handles, false, 0.0}, mouse).has_value();
    if (on_handle && !sight.selection.holds(found->id)) return nullptr;
    return std::make_unique<PinTool>(found->id, sight, snap);
}

}  // namespace hanei
