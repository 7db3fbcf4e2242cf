#include "ui/panels/viewport.h"

#include "engine/edit/luminaire_edits.h"
#include "engine/scene/dimmers.h"
#include "ui/panels/box_tool.h"
#include "ui/panels/choosing.h"
#include "ui/panels/key.h"
#include "ui/panels/style.h"
#include "ui/view/pick.h"

#include <algorithm>
#include <cmath>

namespace hanei {
namespace {

constexpr float click_slack = 4.0F;  // pixels a click may move and still be a click

double reach_of(const Scene& scene) { return 4.0 * std::max(1.0, bounds_of(scene).diameter()); }

float distance(ImVec2 a, ImVec2 b) { return std::hypot(a.x - b.x, a.y - b.y); }

}  // namespace

void Viewport::frame(const Bounds& bounds) { state.go_to(fitted(state.camera, bounds, aspect())); }

Viewport::Pointed Viewport::pointed(const Scene& scene, ImVec2 at) const {
    const std::optional<int> under = state.panes.under(at);
    if (!under) return {};
    const Pane& pane = state.panes.pane(*under);
    return {pane.ray(at), pick(scene, pane.camera, pane.within(at), pane.aspect())};
}

ViewOptions Viewport::options_of(const Input& input, int k) const {
    ViewOptions look = state.options;
    look.dark_background = style::theme() == Theme::dark;
    look.part = state.panes.part(k, look.part);
    if (input.difference) look = as_difference(std::move(look), *input.difference);
    look.shadow_classes &= !state.panes.shows_parts();
    const ObjectKind kind = kind_of(*input.scene, input.selection.primary());
    look.shadows_of = kind == ObjectKind::luminaire ? input.selection.primary() : ObjectId{};
    look.grids |= (kind == ObjectKind::grid || kind == ObjectKind::point) && !input.difference;
    return look;
}

void Viewport::paint_panes(const Input& input, const ViewPainter& paint) {
    // A room that is only being built is shown in the colours of its materials: darkness says nothing.
    const SolutionSnapshot lit = holds_light(*input.scene) ? input.solution : nullptr;
    for (int k = 0; k < state.panes.count(); ++k) {
        const Pane& pane = state.panes.pane(k);
        ViewRequest request{
            k, input.painted ? input.painted : input.scene, lit, pane.camera, options_of(input, k), {}, {}, moving()};
        request.size = {static_cast<int>(pane.width), static_cast<int>(pane.height)};
        request.highlights.selected = objects_of(*input.scene, input.selection.ids());
        request.highlights.hovered = hovered_;
        if (void* texture = paint(request)) {
            ImGui::GetWindowDrawList()->AddImage(texture, {pane.left, pane.top},
                                                 {pane.left + pane.width, pane.top + pane.height}, {0.0F, 1.0F},
                                                 {1.0F, 0.0F});
        }
    }
}

Viewport::Outcome Viewport::draw(const Input& input, const ViewPainter& paint, WidgetRegistry& widgets) {
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    const ImVec2 room = ImGui::GetContentRegionAvail();
    const float kept_clear = state.panes.count() > 1 ? right_margin : 0.0F;
    const ScreenRect all{corner.x, corner.y, corner.x + std::max(16.0F, std::floor(room.x - kept_clear)),
                         corner.y + std::max(16.0F, std::floor(room.y))};
    right_edge_ = all.right;
    PaneSet& panes = state.panes;
    panes.lay_out(all, state.camera);
    panes.follow_shapes(state.camera, bounds_of(*input.scene), covered());
    follow_passage();
    panes.lay_out(all, present_camera());
    ImGui::InvisibleButton(
        "view", {all.right - all.left, all.bottom - all.top},
        ImGuiButtonFlags_MouseButtonLeft | ImGuiButtonFlags_MouseButtonRight | ImGuiButtonFlags_MouseButtonMiddle);
    ImGui::SetItemAllowOverlap();  // the scale and its fields stand over it
    widgets.note("view");
    const bool hovered = ImGui::IsItemHovered();
    if (passage_ && (ImGui::IsItemActivated() || (hovered && ImGui::GetIO().MouseWheel != 0.0F))) {
        passage_.reset();  // what is done is done to the picture at its end
        panes.lay_out(all, state.camera);
    }
    choose_pane(hovered);

    Outcome outcome = handle_mouse(input, hovered);
    panes.lay_out(all, present_camera());  // with the cameras as they are after that
    read_light(input, panes.pane(under_pointer_), hovered);
    paint_panes(input, paint);
    ImDrawList& draw_list = *ImGui::GetWindowDrawList();
    for (int k = 0; k < panes.count(); ++k) {
        const Pane& each = panes.pane(k);
        draw_list.PushClipRect({each.left, each.top}, {each.left + each.width, each.top + each.height}, true);
        draw_isolux_labels(input, each, k);
        draw_planes(input, each, widgets);
        for (ViewOverlay* overlay : input.overlays) overlay->draw(sight_of(input, k, hovered), widgets);
        if (tool_)
            tool_->draw(sight_of(input, k, hovered), widgets);
        else
            draw_handles(input, each, widgets);
        draw_section(input, k, widgets);
        draw_aids(input, k, widgets);
        if (drag_ && drag_->begun && !drag_->over) draw_guides(each, drag_->gesture);
        draw_list.PopClipRect();
    }
    draw_pane_frames(input, all, widgets);
    draw_readout(input, all);
    return outcome;
}

PaneSight Viewport::sight_of(const Input& input, int k, bool hovered) const {
    return {state.panes.pane(k),           k, input.scene, input.answer, input.selection, input.snap.raster_now(),
            hovered && under_pointer_ == k};
}

Viewport::Outcome Viewport::handle_mouse(const Input& input, bool hovered) {
    const Pane pane = state.panes.pane(under_pointer_);
    const ImVec2 mouse = ImGui::GetIO().MousePos;
    if (tool_) {
        if (!tool_->turns_view()) look_around(pane);
        return handle_tool(input, hovered);
    }
    Outcome outcome;
    if (ImGui::IsItemActivated()) outcome = handle_press(input, pane);
    if (drag_)
        outcome = handle_drag(pane);
    else
        look_around(pane);
    const bool right_released = ImGui::IsItemDeactivated() && ImGui::IsMouseReleased(ImGuiMouseButton_Right);
    if (right_released && distance(mouse, pressed_at_) < click_slack) {
        const ObjectId hit = pick(*input.scene, pane.camera, pane.within(mouse), pane.aspect());
        const ObjectIds objects = objects_of(*input.scene, input.selection.ids());
        if (std::find(objects.begin(), objects.end(), hit) == objects.end())
            outcome.chosen = chosen_by_click(*input.scene, input.selection, hit, {});
        outcome.menu_wished = true;
    }
    if (!drag_ && ImGui::IsItemDeactivated() && ImGui::IsMouseReleased(ImGuiMouseButton_Left) &&
        distance(mouse, pressed_at_) < click_slack) {
        const ImGuiIO& io = ImGui::GetIO();
        const ObjectId hit = pick(*input.scene, pane.camera, pane.within(mouse), pane.aspect());
        outcome.chosen =
            chosen_by_click(*input.scene, input.selection, hit, {io.KeyShift || io.KeyCtrl, io.KeyAlt, pressed_twice_});
    }
    return outcome;
}

Viewport::Outcome Viewport::handle_tool(const Input& input, bool hovered) {
    ViewTool::Outcome wished = tool_->handle(sight_of(input, under_pointer_, hovered));
    Outcome outcome;
    outcome.moved = std::move(wished.scene);
    outcome.step = std::move(wished.step);
    outcome.released = wished.settles;
    outcome.chosen = std::move(wished.chosen);
    if (wished.finished) tool_.reset();
    return outcome;
}

Viewport::Outcome Viewport::handle_press(const Input& input, const Pane& pane) {
    const ImVec2 mouse = ImGui::GetIO().MousePos;
    pressed_at_ = mouse;
    pressed_twice_ = ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left);
    if (!ImGui::IsMouseClicked(ImGuiMouseButton_Left)) return {};
    if (ImGui::GetIO().KeyShift) {
        take_up(std::make_unique<BoxTool>(options_of(input, under_pointer_).grids, mouse));
        return {};
    }
    if (std::unique_ptr<ViewTool> grip =
            input.grips ? input.grips->take(sight_of(input, under_pointer_, true)) : nullptr) {
        take_up(std::move(grip));
        return {};
    }
    const std::optional<HandleSight> handles = handles_of(input, pane);
    if (!handles) return {};
    std::optional<Grip> grip = handle_at(*handles, mouse);
    const ObjectIds objects = objects_of(*input.scene, input.selection.ids());
    const ObjectId hit = pick(*input.scene, pane.camera, pane.within(mouse), pane.aspect());
    if (!grip && std::find(objects.begin(), objects.end(), hit) != objects.end()) grip = Grip::plane_xy;
    if (!grip) return {};
    auto gesture = ObjectDrag::begin(input.scene, input.selection.ids(), *grip, pane.ray(mouse), reach_of(*input.scene),
                                     input.snap);
    if (gesture) drag_ = Drag{std::move(*gesture)};
    return {};
}

std::optional<HandleSight> Viewport::handles_of(const Input& input, const Pane& pane) const {
    const std::optional<Vec3> place =
        drag_ ? std::optional(drag_->gesture.place()) : middle_of(*input.scene, input.selection.ids());
    if (!place) return std::nullopt;
    const Luminaire* luminaire = find_luminaire(*input.scene, input.selection.primary());
    return HandleSight{pane, *place, luminaire != nullptr, luminaire != nullptr ? luminaire->yaw : 0.0};
}

namespace {

ObjectDrag::Keys drag_keys() {
    const ImGuiIO& io = ImGui::GetIO();
    ObjectDrag::Keys keys;
    keys.frees = io.KeyCtrl;
    keys.erases = ImGui::IsKeyPressed(static_cast<int>(Key::backspace));
    constexpr std::pair<char, Axis> axes[] = {{'X', Axis::x}, {'Y', Axis::y}, {'Z', Axis::z}};
    for (const auto& [letter, axis] : axes)
        if (ImGui::IsKeyPressed(static_cast<int>(key_of(letter)), false)) keys.axis = axis;
    for (const ImWchar letter : io.InputQueueCharacters)
        if (letter < 128) keys.letters += static_cast<char>(letter);
    return keys;
}

bool is_pressed(Key key) { return ImGui::IsKeyPressed(static_cast<int>(key), false); }

}  // namespace

Viewport::Outcome Viewport::handle_drag(const Pane& pane) {
    const ImGuiIO& io = ImGui::GetIO();
    Outcome outcome;
    const bool let_go = !io.MouseDown[ImGuiMouseButton_Left];
    if (drag_->over) {
        if (let_go) drag_.reset();
        return outcome;
    }
    const ObjectDrag::Keys keys = drag_keys();
    drag_->begun |= distance(io.MousePos, pressed_at_) >= click_slack || keys.axis || !keys.letters.empty();
    if (drag_->begun) {
        constexpr double caught = 8.0;  // pixels to a line that catches
        const double a_pixel =
            picture_height_at(pane.camera, drag_->gesture.place()) / static_cast<double>(pane.height);
        outcome.moved = drag_->gesture.at(pane.ray(io.MousePos), keys, caught * style::scale() * a_pixel);
        outcome.step = drag_->gesture.step();
    }
    outcome.given_up = is_pressed(Key::escape);
    outcome.released = let_go || is_pressed(Key::enter) || outcome.given_up;
    if (outcome.released && !let_go)
        drag_->over = true;
    else if (outcome.released)
        drag_.reset();
    return outcome;
}

void Viewport::read_light(const Input& input, const Pane& pane, bool hovered) {
    const ImVec2 mouse = ImGui::GetIO().MousePos;
    if (!hovered || moving() || !pane.holds(mouse)) {
        hovered_ = {};
        if (!moving()) probe_.reset();
        probed_.at = {-1.0F, -1.0F};
        return;
    }
    const bool same = probed_.at.x == mouse.x && probed_.at.y == mouse.y && probed_.camera == pane.camera &&
                      probed_.solution == input.answer && probed_.scene == input.scene;
    if (same) return;
    probed_ = {mouse, pane.camera, input.answer, input.scene};
    hovered_ = pick(*input.scene, pane.camera, pane.within(mouse), pane.aspect());
    probe_.reset();
    if (input.answer) probe_ = probe_at(*input.answer, pane.ray(mouse));
}

}  // namespace hanei
