#include "engine/edit/control_groups.h"
#include "engine/scene/colour.h"
#include "ui/panels/properties.h"
#include "ui/panels/property_rows.h"

#include <fmt/format.h>
#include <imgui.h>

namespace hanei {

std::optional<Scene> control_group_panel(const Scene& scene, ObjectId id, Form& form) {
    const ControlGroup* const found = find_control_group(scene, id);
    if (!found) return std::nullopt;
    ControlGroup group = *found;
    bool changed = form.text("group.name", "Name", "What this group of luminaires is called", group.name);
    changed |=
        percent_row({"group.dimming", "Dimmer", "%", "Times the dimmer of each of its luminaires", 0.0, 100.0, 0.5, 1},
                    group.dimming, form);
    changed |= light_colour_rows({"group.colour", "group.temperature", "Own of each"}, group.colour_temperature, form);
    form.fact("Luminaires", std::to_string(members_of(scene, id)));
    if (!changed) return std::nullopt;
    Scene wished = scene;
    for (ControlGroup& each : wished.control_groups)
        if (each.id == id) each = group;
    return wished;
}

std::optional<Scene> light_scene_panel(const Scene& scene, ObjectId id, Form& form) {
    const LightScene* const found = find_light_scene(scene, id);
    if (!found) return std::nullopt;
    LightScene light_scene = *found;
    bool changed = form.text("light_scene.name", "Name", "What this light scene is called", light_scene.name);
    form.heading("Dimmers");
    for (LightScene::Level& level : light_scene.levels) {
        const ControlGroup* const group = find_control_group(scene, level.group);
        if (!group) continue;
        ImGui::PushID(static_cast<int>(level.group.value));  // names may be alike
        const std::string name = "light_scene.level." + group->name;
        changed |= percent_row(
            {name.c_str(), group->name.c_str(), "%", "Where this light scene sets the group", 0.0, 100.0, 0.5, 1},
            level.dimming, form);
        ImGui::PopID();
    }
    if (form.button("light_scene.recall", "Switch to it", "Sets the dimmers of its groups")) return recalled(scene, id);
    if (form.button("light_scene.store", "Store the present dimmers", "It recalls them as they are now"))
        return with_stored_levels(scene, id);
    if (!changed) return std::nullopt;
    Scene wished = scene;
    for (LightScene& each : wished.light_scenes)
        if (each.id == id) each = light_scene;
    return wished;
}

}  // namespace hanei
