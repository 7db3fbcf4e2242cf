#include "engine/edit/control_groups.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace hanei {
namespace {

/// "Group 3": the first number that no object of the list has.
template <class Object>
std::string numbered(const char* what, const std::vector<Object>& list) {
    for (std::size_t number = list.size() + 1;; ++number) {
        std::string name = fmt::format("{} {}", what, number);
        if (std::none_of(list.begin(), list.end(), [&](const Object& object) { return object.name == name; }))
            return name;
    }
}

ControlGroup* group_in(Scene& scene, ObjectId id) {
    const auto found = std::find_if(scene.control_groups.begin(), scene.control_groups.end(),
                                    [&](const ControlGroup& group) { return group.id == id; });
    return found == scene.control_groups.end() ? nullptr : &*found;
}

}  // namespace

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

int members_of(const Scene& scene, ObjectId group) {
    return static_cast<int>(std::count_if(scene.luminaires.begin(), scene.luminaires.end(),
                                          [&](const Luminaire& luminaire) { return luminaire.group == group; }));
}

Scene with_group_of(Scene scene, std::span<const ObjectId> luminaires, ObjectId group) {
    for (Luminaire& luminaire : scene.luminaires)
        if (std::find(luminaires.begin(), luminaires.end(), luminaire.id) != luminaires.end()) luminaire.group = group;
    return scene;
}

Added with_control_group(Scene scene, std::span<const ObjectId> luminaires) {
    ControlGroup group;
    group.id = scene.new_id();
    group.name = numbered("Group", scene.control_groups);
    const ObjectId id = group.id;
    scene.control_groups.push_back(std::move(group));
    return {with_group_of(std::move(scene), luminaires, id), id};
}

Scene dimmed(Scene scene, ObjectId group, double level) {
    if (ControlGroup* found = group_in(scene, group)) found->dimming = std::clamp(level, 0.0, 1.0);
    return scene;
}

Scene alone(Scene scene, ObjectId group) {
    if (!find_control_group(scene, group)) return scene;
    for (ControlGroup& each : scene.control_groups) {
        if (each.id != group)
            each.dimming = 0.0;
        else if (each.dimming <= 0.0)
            each.dimming = 1.0;
    }
    return scene;
}

const LightScene* find_light_scene(const Scene& scene, ObjectId id) {
    const auto found = std::find_if(scene.light_scenes.begin(), scene.light_scenes.end(),
                                    [&](const LightScene& light_scene) { return light_scene.id == id; });
    return found == scene.light_scenes.end() ? nullptr : &*found;
}

std::vector<LightScene::Level> present_levels(const Scene& scene) {
    std::vector<LightScene::Level> levels;
    for (const ControlGroup& group : scene.control_groups) levels.push_back({group.id, group.dimming});
    return levels;
}

Scene with_levels(Scene scene, std::span<const LightScene::Level> levels) {
    for (const LightScene::Level& level : levels) scene = dimmed(std::move(scene), level.group, level.dimming);
    return scene;
}

Scene recalled(Scene scene, ObjectId light_scene) {
    const LightScene* const found = find_light_scene(scene, light_scene);
    if (!found) return scene;
    const std::vector<LightScene::Level> levels = found->levels;
    return with_levels(std::move(scene), levels);
}

bool is_recalled(const Scene& scene, const LightScene& light_scene) {
    constexpr double same = 1e-9;  // of levels that went through a file in percent
    const auto stands = [&](const LightScene::Level& level) {
        const ControlGroup* const group = find_control_group(scene, level.group);
        return group && std::abs(group->dimming - level.dimming) < same;
    };
    return !light_scene.levels.empty() && std::all_of(light_scene.levels.begin(), light_scene.levels.end(), stands);
}

Scene with_stored_levels(Scene scene, ObjectId light_scene) {
    std::vector<LightScene::Level> levels = present_levels(scene);
    for (LightScene& each : scene.light_scenes)
        if (each.id == light_scene) each.levels = std::move(levels);
    return scene;
}

Added with_light_scene(Scene scene) {
    LightScene made;
    made.id = scene.new_id();
    made.name = numbered("Light scene", scene.light_scenes);
    made.levels = present_levels(scene);
    const ObjectId id = made.id;
    scene.light_scenes.push_back(std::move(made));
    return {std::move(scene), id};
}

}  // namespace hanei
