#include "engine/edit/control_groups.h"

namespace hanei {

ObjectId control_group_named(Scene& scene, const std::string& name) {
    if (name.empty()) return {};
    for (const ControlGroup& group : scene.control_groups)
        if (group.name == name) return group.id;
    ControlGroup group;
    group.id = scene.new_id();
    group.name = name;
    scene.control_groups.push_back(std::move(group));
    return scene.control_groups.back().id;
}

}  // namespace hanei
