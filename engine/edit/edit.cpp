#include "engine/edit/edit.h"

#include "engine/edit/arrangements.h"
#include "engine/edit/with_object.h"

#include <algorithm>

namespace hanei {
namespace {

template <class Object>
bool erase(std::vector<Object>& list, ObjectId id) {
    return std::erase_if(list, [&](const Object& object) { return object.id == id; }) > 0;
}

}  // namespace

ObjectKind kind_of(const Scene& scene, ObjectId id) {
    ObjectKind found = ObjectKind::none;
    with_object(scene, id, [&](const auto&, ObjectKind kind) { found = kind; });
    return found;
}

std::string_view name_of(ObjectKind kind) {
    switch (kind) {
        case ObjectKind::none:
            return "nothing";
        case ObjectKind::room:
            return "room";
        case ObjectKind::furniture:
            return "furniture";
        case ObjectKind::surface:
            return "surface";
        case ObjectKind::luminaire:
            return "luminaire";
        case ObjectKind::grid:
            return "calculation grid";
        case ObjectKind::point:
            return "calculation point";
        case ObjectKind::view:
            return "view";
        case ObjectKind::material:
            return "material";
        case ObjectKind::control_group:
            return "control group";
        case ObjectKind::light_scene:
            return "light scene";
        case ObjectKind::arrangement:
            return "arrangement";
        case ObjectKind::object_group:
            return "group";
        case ObjectKind::sub_area:
            return "part of a wall";
    }
    return {};
}

std::string display_name(const Scene& scene, ObjectId id) {
    std::string name;
    with_object(scene, id, [&](const auto& object, ObjectKind kind) {
        name = object.name;
        if (!name.empty()) return;
        name = std::string(name_of(kind)) + " " + std::to_string(id.value);
        name[0] = static_cast<char>(name[0] - 'a' + 'A');
    });
    return name;
}

ObjectId object_named(const Scene& scene, const std::string& name) {
    const auto search = [&](const auto& list) {
        for (const auto& object : list) {
            if (display_name(scene, object.id) == name) return object.id;
        }
        return ObjectId{};
    };
    ObjectId found = search(scene.luminaires);
    if (!found) found = search(scene.furniture);
    if (!found) found = search(scene.grids);
    if (!found) found = search(scene.points);
    if (!found) found = search(scene.surfaces);
    if (!found) found = search(scene.views);
    if (!found) found = search(scene.materials);
    if (!found && scene.room) found = search(scene.room->sub_areas);
    if (!found) found = search(scene.arrangements);
    if (!found) found = search(scene.control_groups);
    if (!found) found = search(scene.light_scenes);
    if (!found && scene.room && display_name(scene, scene.room->id) == name) found = scene.room->id;
    return found;
}

bool can_remove(ObjectKind kind) {
    return kind != ObjectKind::none && kind != ObjectKind::room && kind != ObjectKind::material;
}

namespace {

/// Nothing names the object any longer; arrangements and groups that are left empty go with it.
void forget(Scene& scene, ObjectId id) {
    for (Luminaire& luminaire : scene.luminaires)
        if (luminaire.group == id) luminaire.group = {};
    for (LightScene& light_scene : scene.light_scenes)
        std::erase_if(light_scene.levels, [&](const LightScene::Level& level) { return level.group == id; });
    for (Arrangement& arrangement : scene.arrangements)
        std::replace(arrangement.luminaires.begin(), arrangement.luminaires.end(), id, ObjectId{});
    for (ObjectGroup& group : scene.object_groups) std::erase(group.members, id);
    std::erase_if(scene.arrangements, [](const Arrangement& arrangement) {
        return std::none_of(arrangement.luminaires.begin(), arrangement.luminaires.end(),
                            [](ObjectId kept) { return bool(kept); });
    });
    std::erase_if(scene.object_groups, [](const ObjectGroup& group) { return group.members.empty(); });
}

}  // namespace

Scene removed(Scene scene, ObjectId id) {
    if (const Arrangement* arrangement = find_arrangement(scene, id)) {
        const std::vector<ObjectId> members = arrangement->luminaires;
        for (const ObjectId member : members) scene = removed(std::move(scene), member);
    }
    if (scene.room) erase(scene.room->sub_areas, id);
    erase(scene.furniture, id);
    erase(scene.surfaces, id);
    erase(scene.luminaires, id);
    erase(scene.grids, id);
    erase(scene.points, id);
    erase(scene.views, id);
    erase(scene.control_groups, id);
    erase(scene.light_scenes, id);
    erase(scene.arrangements, id);
    erase(scene.object_groups, id);
    forget(scene, id);
    return scene;
}

}  // namespace hanei
