#include "engine/edit/edit.h"
#include "ui/panels/form.h"
#include "ui/panels/language.h"
#include "ui/panels/style.h"
#include "ui/panels/viewport.h"
#include "ui/view/legend.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace hanei {
namespace {

constexpr float drag_slack = 4.0F;   // pixels a click may move and still be a click
constexpr double turn_rate = 0.008;  // rad a pixel: half a turn over 400 pixels
constexpr double zoom_a_notch = 1.15;

constexpr std::array part_names{
    std::pair{LightPart::total, "Total light"}, std::pair{LightPart::direct, "Direct light"},
    std::pair{LightPart::interreflected, "Interreflected light"}, std::pair{LightPart::unshadowed, "Without shadows"}};

const char* part_name(LightPart part) {
    return std::find_if(part_names.begin(), part_names.end(), [&](const auto& entry) { return entry.first == part; })
        ->second;
}

/// A saved view by its name, a drawing by its own, else how it is projected.
std::string name_of_look(const Scene& scene, const Camera& camera) {
    for (const View& view : scene.views) {
        if (camera_of(view) == camera) return display_name(scene, view.id);
    }
    if (const auto standpoint = standpoint_of(camera)) return std::string(tr(name_of(*standpoint)));
    return tr(camera.orthographic ? "Parallel" : "Perspective");
}

}  // namespace

void ViewState::show(LightPart part, const Scene& scene) {
    if (panes.shows_parts()) toggle(PaneLayout::four_parts, scene);
    options.part = part;
    options.shadow_classes = false;
}

void ViewState::toggle_shadow_classes(const Scene& scene) {
    options.shadow_classes = panes.shows_parts() || !options.shadow_classes;
    if (panes.shows_parts()) toggle(PaneLayout::four_parts, scene);
}

void Viewport::look_from(Standpoint standpoint, const Scene& scene) {
    const Camera from = state.camera;
    state.panes.look_from(standpoint, state.camera, bounds_of(scene), covered());
    state.came_from = from;
}

/// A press or the wheel makes the picture under the pointer the active one.
void Viewport::choose_pane(bool hovered) {
    const ImGuiIO& io = ImGui::GetIO();
    if (!ImGui::IsItemActive() || ImGui::IsItemActivated())
        under_pointer_ = state.panes.under(io.MousePos).value_or(state.panes.active());
    if (ImGui::IsItemActivated() || (hovered && io.MouseWheel != 0.0F))
        state.panes.activate(under_pointer_, state.present());
}

void Viewport::look_around(const Pane& pane) {
    const ImGuiIO& io = ImGui::GetIO();
    turning_ = false;
    Camera& camera = state.camera;
    if (ImGui::IsItemHovered() && io.MouseWheel != 0.0F) {
        camera = zoomed(camera, std::pow(zoom_a_notch, static_cast<double>(io.MouseWheel)), pane.within(io.MousePos),
                        pane.aspect());
    }
    if (!ImGui::IsItemActive()) return;
    const bool left = !tool_ && ImGui::IsMouseDragging(ImGuiMouseButton_Left, drag_slack);
    const bool right = ImGui::IsMouseDragging(ImGuiMouseButton_Right, 0.0F);
    const bool middle = ImGui::IsMouseDragging(ImGuiMouseButton_Middle, 0.0F);
    if (!left && !right && !middle) return;
    turning_ = true;
    const Vec2 by{static_cast<double>(io.MouseDelta.x), static_cast<double>(io.MouseDelta.y)};
    const bool drawing = standpoint_of(camera).has_value();
    if (middle || (io.KeyShift && !left) || (left && drawing)) {
        camera = panned(camera, by / static_cast<double>(pane.height), pane.aspect());
    } else {
        camera.orthographic &= !drawing;  // a plan that is turned becomes a view again
        camera = orbited(camera, turn_rate * by);
    }
}

void Viewport::pane_menu(const Input& input, int k, WidgetRegistry& widgets) {
    const Scene& scene = *input.scene;
    state.panes.activate(k, state.present());
    const std::optional<Standpoint> present = standpoint_of(state.camera);
    for (const Standpoint standpoint : standpoints) {
        const std::string name(name_of(standpoint));
        if (ImGui::MenuItem(tr(name).data(), nullptr, present == standpoint)) look_from(standpoint, scene);
        widgets.note("pane." + name);
    }
    if (!scene.views.empty()) ImGui::Separator();
    for (const View& view : scene.views) {
        const std::string label = fmt::format("{}##{}", display_name(scene, view.id), view.id.value);
        if (ImGui::MenuItem(label.c_str(), nullptr, camera_of(view) == state.camera)) state.go_to(camera_of(view));
    }
    ImGui::Separator();
    for (const auto& [part, name] : part_names) {
        if (ImGui::MenuItem(tr(name), nullptr, state.options.part == part)) state.show(part, scene);
        widgets.note(fmt::format("pane.{}", name));
    }
    ImGui::Separator();
    if (ImGui::MenuItem(tr("This picture alone"))) state.choose(PaneLayout::single, scene);
    widgets.note("pane.alone");
}

/// What a picture shows, as a button with a menu; beside four parts of the light, their names alone.
void Viewport::draw_pane_title(const Input& input, int k, WidgetRegistry& widgets) {
    const Pane& pane = state.panes.pane(k);
    const LightPart part = state.panes.part(k, state.options.part);
    if (state.panes.shows_parts()) return draw_title(pane, tr(heading_of(part)).data());
    const float scale = style::scale();
    const std::string look = name_of_look(*input.scene, state.panes.camera(k, state.camera));
    const std::string text = fmt::format("{}  ·  {}     ###title{}", look, tr(part_name(part)), k);
    ImGui::SetCursorScreenPos({pane.left + 10.0F * scale, pane.top + 10.0F * scale});
    ImGui::PushStyleColor(ImGuiCol_Button, style::card);
    ImGui::PushStyleColor(ImGuiCol_ButtonHovered, style::popup);
    ImGui::PushStyleVar(ImGuiStyleVar_FrameRounding, 5.0F * scale);
    const std::string popup = fmt::format("pane menu {}", k);
    if (ImGui::Button(text.c_str())) ImGui::OpenPopup(popup.c_str());
    ImGui::PopStyleVar();
    ImGui::PopStyleColor(2);
    widgets.note(fmt::format("pane.{}", k + 1));
    const ImVec2 low = ImGui::GetItemRectMin(), high = ImGui::GetItemRectMax();
    const ImVec2 tip{high.x - 12.0F * scale, 0.5F * (low.y + high.y) + 2.5F * scale};
    ImGui::GetWindowDrawList()->AddTriangleFilled({tip.x - 4.0F * scale, tip.y - 4.5F * scale},
                                                  {tip.x + 4.0F * scale, tip.y - 4.5F * scale}, tip, style::quiet_text);
    if (!ImGui::BeginPopup(popup.c_str())) return tooltip(tr("What this picture shows"));
    pane_menu(input, k, widgets);
    ImGui::EndPopup();
}

/// The gaps between pictures can be dragged; a double click makes them even.
void Viewport::draw_dividers(const ScreenRect& all, WidgetRegistry& widgets) {
    const Pane& first = state.panes.pane(0);
    const float reach = 4.0F * style::scale();
    const auto divider = [&](const char* name, const ScreenRect& area, int axis, float whole) {
        ImGui::SetCursorScreenPos({area.left, area.top});
        ImGui::InvisibleButton(name, {area.right - area.left, area.bottom - area.top});
        widgets.note(name);
        double& share = state.panes.divider[axis];
        if (ImGui::IsItemHovered() || ImGui::IsItemActive())
            ImGui::SetMouseCursor(axis == 0 ? ImGuiMouseCursor_ResizeEW : ImGuiMouseCursor_ResizeNS);
        const ImVec2 by = ImGui::GetIO().MouseDelta;
        if (ImGui::IsItemActive())
            share = std::clamp(share + static_cast<double>((axis == 0 ? by.x : by.y) / whole), 0.15, 0.85);
        if (ImGui::IsItemHovered() && ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left)) share = 0.5;
    };
    const float x = first.left + first.width, y = first.top + first.height;
    divider("view.divider", {x - reach, all.top, x + reach, all.bottom}, 0, all.right - all.left);
    if (state.panes.layout() == PaneLayout::four)
        divider("view.divider_level", {all.left, y - reach, all.right, y + reach}, 1, all.bottom - all.top);
}

void Viewport::draw_pane_frames(const Input& input, const ScreenRect& all, WidgetRegistry& widgets) {
    if (state.panes.count() == 1) return;
    if (state.panes.is_divided()) {
        const Pane& active = state.panes.active_pane();
        ImGui::GetWindowDrawList()->AddRect({active.left + 0.5F, active.top + 0.5F},
                                            {active.left + active.width - 0.5F, active.top + active.height - 0.5F},
                                            style::accent, 0.0F, ImDrawFlags_None, 1.5F * style::scale());
        draw_dividers(all, widgets);
    }
    for (int k = 0; k < state.panes.count(); ++k) draw_pane_title(input, k, widgets);
}

}  // namespace hanei
