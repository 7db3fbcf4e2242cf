#include "ui/panels/saved_views.h"

#include "engine/edit/excerpt.h"
#include "ui/panels/form.h"
#include "ui/panels/language.h"
#include "ui/panels/section.h"
#include "ui/panels/style.h"

#include <algorithm>
#include <fmt/format.h>
#include <imgui.h>
#include <imgui_stdlib.h>

namespace hanei {
namespace {

auto found(Scene& scene, ObjectId id) {
    return std::find_if(scene.views.begin(), scene.views.end(), [&](const View& view) { return view.id == id; });
}

}  // namespace

ViewEdit with_kept_view(Scene scene, const Camera& camera) {
    View kept = view_of(camera, free_name(scene, fmt::format("View {}", scene.views.size() + 1)));
    kept.id = scene.new_id();
    scene.views.push_back(std::move(kept));
    return {std::move(scene), "Keep view"};
}

ViewEdit with_updated_view(Scene scene, ObjectId view, const Camera& camera) {
    if (const auto at = found(scene, view); at != scene.views.end()) {
        View updated = view_of(camera, at->name);
        updated.id = at->id;
        updated.unknown = at->unknown;
        *at = std::move(updated);
    }
    return {std::move(scene), "Update view"};
}

ViewEdit with_renamed_view(Scene scene, ObjectId view, const std::string& name) {
    const std::size_t first = name.find_first_not_of(" \t"), last = name.find_last_not_of(" \t");
    const bool taken =
        first == std::string::npos || std::any_of(scene.views.begin(), scene.views.end(), [&](const View& each) {
            return each.id != view && each.name == name.substr(first, last + 1 - first);
        });
    if (const auto at = found(scene, view); at != scene.views.end() && !taken)
        at->name = name.substr(first, last + 1 - first);
    return {std::move(scene), "Rename view"};
}

ViewEdit with_view_moved_up(Scene scene, ObjectId view) {
    const auto at = found(scene, view);
    if (at != scene.views.end() && at != scene.views.begin()) std::iter_swap(at, at - 1);
    return {std::move(scene), "Move view up"};
}

ViewEdit without_view(Scene scene, ObjectId view) {
    std::erase_if(scene.views, [&](const View& each) { return each.id == view; });
    return {std::move(scene), "Delete view"};
}

namespace {

/// Name, lens, ceiling and section of a kept view.
std::optional<ViewEdit> edit_rows(ViewState& state, const Scene& scene, const View& view, const std::string& name,
                                  WidgetRegistry& widgets) {
    std::optional<ViewEdit> edit;
    ImGui::Indent();
    std::string typed = view.name;
    ImGui::SetNextItemWidth(150.0F * style::scale());
    ImGui::InputText(fmt::format("{}###name", tr("Name")).c_str(), &typed);
    widgets.note(name + ".name");
    tooltip(tr("What this view is called"));
    if (typed != view.name) edit = with_renamed_view(scene, view.id, typed);
    Camera camera = camera_of(view);
    const bool is_shown = camera == state.camera;
    if (section_rows(camera, bounds_of(scene), name, widgets)) {
        edit = with_updated_view(scene, view.id, camera);
        if (is_shown) state.camera = camera;
    }
    ImGui::Unindent();
    return edit;
}

}  // namespace

std::optional<ViewEdit> saved_view_rows(ViewState& state, const Scene& scene, WidgetRegistry& widgets) {
    std::optional<ViewEdit> edit;
    if (scene.views.empty()) ImGui::TextDisabled("%s", tr("None kept yet (Ctrl+K)"));
    const float buttons = 190.0F * style::scale();
    int& edited = *ImGui::GetStateStorage()->GetIntRef(ImGui::GetID("###edited"));
    for (std::size_t k = 0; k < scene.views.size(); ++k) {
        const View& view = scene.views[k];
        const std::string name = display_name(scene, view.id);
        const auto number = static_cast<int>(view.id.value);
        ImGui::PushID(number);
        const std::string chord = k < 9 ? fmt::format("  Ctrl+{}", k + 1) : "";
        const bool present = camera_of(view) == state.camera;
        if (ImGui::Selectable((name + chord + "###view").c_str(), present, 0, {buttons, 0.0F}))
            state.go_to(camera_of(view));
        widgets.note("views." + name);
        const auto button = [&](const char* label, const char* word, const char* help) {
            ImGui::SameLine();
            const bool pressed = ImGui::SmallButton(tr(label));
            widgets.note(fmt::format("views.{}.{}", name, word));
            tooltip(tr(help));
            return pressed;
        };
        if (button("Edit", "edit", "Its name, field of view, ceiling and section plane"))
            edited = edited == number ? 0 : number;
        if (button("Update", "update", "Keep the present picture under this name"))
            edit = with_updated_view(scene, view.id, state.camera);
        if (button("Up", "up", "Before the one above it")) edit = with_view_moved_up(scene, view.id);
        if (button("Delete", "delete", "Keep this view no longer")) edit = without_view(scene, view.id);
        if (edited == number) {
            if (auto wished = edit_rows(state, scene, view, fmt::format("views.{}", name), widgets))
                edit = std::move(wished);
        }
        ImGui::PopID();
    }
    return edit;
}

}  // namespace hanei
