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
    const ObjectIds all = found.content ? all_objects(found.content->scene) : ObjectIds{};
    if (all.empty()) {
        const std::string why = found.findings.empty() ? std::string() : ": " + found.findings.front().message;
        message_ = tr("The clipboard holds no objects of a project") + why;
        return;
    }
    const Scene& scene = *document_.shown();
    const Bounds bounds = *bounds_of_objects(found.content->scene, all);
    Vec3 by{bounds.high.x - bounds.low.x + 0.1, 0.0, 0.0};
    const Viewport::Pointed pointed = viewport_.pointed(scene, menu_at_.value_or(ImGui::GetIO().MousePos));
    if (pointed.ray) {
        const Vec2 place = place_in_plan(scene, pointed.ray, raster());
        by = {place.x - 0.5 * (bounds.low.x + bounds.high.x), place.y - 0.5 * (bounds.low.y + bounds.high.y), 0.0};
        for (int axis = 0; axis < 2; ++axis) by[axis] = snapped(by[axis], raster());
    }
    const std::string words = words_for(found.content->scene, all);
    add(with_excerpt(scene, excerpt(found.content->scene, all), by), "Paste " + words);
    message_ = say("Pasted {}", phrase(words));
}

}  // namespace hanei
