#include "ui/panels/saved_views.h"

#include "engine/edit/excerpt.h"
#include "ui/panels/form.h"
#include "ui/panels/language.h"
#include "ui/panels/style.h"

#include <algorithm>
#include <fmt/format.h>
#include <imgui.h>

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

ViewEdit with_view_moved_up(Scene scene, ObjectId view) {
    const auto at = found(scene, view);
    if (at != scene.views.end() && at != scene.views.begin()) std::iter_swap(at, at - 1);
    return {std::move(scene), "Move view up"};
}

ViewEdit without_view(Scene scene, ObjectId view) {
    std::erase_if(scene.views, [&](const View& each) { return each.id == view; });
    return {std::move(scene), "Delete view"};
}

std::optional<ViewEdit> saved_view_rows(ViewState& state, const Scene& scene, WidgetRegistry& widgets) {
    std::optional<ViewEdit> edit;
    if (scene.views.empty()) ImGui::TextDisabled("%s", tr("None kept yet (Ctrl+K)"));
    const float buttons = 190.0F * style::scale();
    for (std::size_t k = 0; k < scene.views.size(); ++k) {
        const View& view = scene.views[k];
        const std::string name = display_name(scene, view.id);
        ImGui::PushID(static_cast<int>(view.id.value));
        const std::string chord = k < 9 ? fmt::format("  Ctrl+{}", k + 1) : "";
        const bool present = camera_of(view) == state.camera;
        if (ImGui::Selectable((name + chord + "###view").c_str(), present, 0, {buttons, 0.0F}))
            state.camera = camera_of(view);
        widgets.note("views." + name);
        const auto button = [&](const char* label, const char* word, const char* help) {
            ImGui::SameLine();
            const bool pressed = ImGui::SmallButton(tr(label));
            widgets.note(fmt::format("views.{}.{}", name, word));
            tooltip(tr(help));
            return pressed;
        };
        if (button("Update", "update", "Keep the present picture under this name"))
            edit = with_updated_view(scene, view.id, state.camera);
        if (button("Up", "up", "Before the one above it")) edit = with_view_moved_up(scene, view.id);
        if (button("Delete", "delete", "Keep this view no longer")) edit = without_view(scene, view.id);
        ImGui::PopID();
    }
    return edit;
}

}  // namespace hanei
