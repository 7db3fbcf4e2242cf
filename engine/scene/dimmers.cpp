#include "engine/scene/dimmers.h"

#include <algorithm>

namespace hanei {

const ControlGroup* find_control_group(const Scene& scene, ObjectId id) {
    if (!id) return nullptr;
    const auto found = std::find_if(scene.control_groups.begin(), scene.control_groups.end(),
                                    [&](const ControlGroup& group) { return group.id == id; });
    return found == scene.control_groups.end() ? nullptr : &*found;
}

double group_dimming_of(const Scene& scene, const Luminaire& luminaire) {
    const ControlGroup* const group = find_control_group(scene, luminaire.group);
    return group ? group->dimming : 1.0;
}

double dimming_of(const Scene& scene, const Luminaire& luminaire) {
    return luminaire.dimming * group_dimming_of(scene, luminaire);
}

double colour_temperature_of(const Scene& scene, const Luminaire& luminaire) {
    const ControlGroup* const group = find_control_group(scene, luminaire.group);
    return group && group->colour_temperature > 0.0 ? group->colour_temperature : luminaire.colour_temperature;
}

bool holds_light(const Scene& scene) {
    return !scene.luminaires.empty() ||
           std::any_of(scene.surfaces.begin(), scene.surfaces.end(),
                       [](const FreeSurface& surface) { return surface.own_exitance.value > 0.0; });
}

}  // namespace hanei
