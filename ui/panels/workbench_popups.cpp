#include "engine/edit/hanging.h"
#include "ui/panels/hanging.h"
#include "ui/panels/language.h"
#include "ui/panels/workbench.h"

#include <fmt/format.h>
#include <imgui.h>

namespace hanei {

void Workbench::open_context_menu(const Selection& chosen) {
    menu_at_ = ImGui::GetIO().MousePos;
    context_menu_.open(kind_of(*document_.shown(), chosen.primary()));
}

void Workbench::popups() {
    const auto possible = [this](CommandId id) { return can(id); };
    if (const auto wished = context_menu_.draw(possible, widgets_)) carry_out(*wished);
    if (const auto wished = search_.draw(possible, widgets_)) carry_out(*wished);
    if (const auto step = history_list_.draw(document_.history(), widgets_)) document_.go_to(*step);
    snap_popup_.draw(snap_, form_);
    if (!ImGui::IsPopupOpen("", ImGuiPopupFlags_AnyPopupId)) menu_at_.reset();
}

/// To the system's clipboard, as the text of a project of these objects alone.
void Workbench::copy_chosen() {
    const Scene& scene = *document_.shown();
    ImGui::SetClipboardText(door_.text({excerpt(scene, selection_.ids()), document_.settings()}).c_str());
    message_ = say("Copied {}", phrase(words_for(scene, selection_.ids())));
}

/// Where the pointer is, else beside what was copied.
void Workbench::paste() {
    const char* const text = ImGui::GetClipboardText();
    const Opened<ProjectContent> found = door_.read_text(text != nullptr ? text : "");
    ObjectIds all = found.content ? all_objects(found.content->scene) : ObjectIds{};
    if (found.content && found.content->scene.room)
        for (const SubArea& area : found.content->scene.room->sub_areas) all.push_back(area.id);
    if (all.empty()) {
        const std::string why = found.findings.empty() ? std::string() : ": " + found.findings.front().message;
        message_ = tr("The clipboard holds no objects of a project") + why;
        return;
    }
    const Scene& scene = *document_.shown();
    const std::optional<Bounds> bounds = bounds_of_objects(found.content->scene, all);
    Vec3 by{bounds ? bounds->high.x - bounds->low.x + 0.1 : 0.0, 0.0, 0.0};
    std::optional<FacePlace> face;
    const Viewport::Pointed pointed = viewport_.pointed(scene, menu_at_.value_or(ImGui::GetIO().MousePos));
    if (pointed.ray && bounds) {
        const Vec2 place = place_in_plan(scene, pointed.ray, raster());
        by = {place.x - 0.5 * (bounds->low.x + bounds->high.x), place.y - 0.5 * (bounds->low.y + bounds->high.y), 0.0};
        for (int axis = 0; axis < 2; ++axis) by[axis] = snapped(by[axis], raster());
    } else if (pointed.ray && scene.room && all.size() == 1) {
        face = face_under(*scene.room, pointed.ray->origin, pointed.ray->direction);
    }
    const std::string words = words_for(found.content->scene, all);
    AddedSeveral pasted = with_excerpt(scene, excerpt(found.content->scene, all), by, face);
    if (pasted.objects.empty()) {
        message_ = tr("There is no room here for what was copied");
        return;
    }
    add(std::move(pasted), "Paste " + words);
    message_ = say("Pasted {}", phrase(words));
}

}  // namespace hanei
