/// Finds an object of a scene by its id, whichever list it stands in.
#pragma once

#include "engine/edit/edit.h"

namespace hanei {

/// Calls `visit(object, kind)` for the object of this id, in whichever list it stands.
template <class SceneType, class Visit>
void with_object(SceneType& scene, ObjectId id, const Visit& visit) {
    if (!id) return;
    const auto search = [&](auto& list, ObjectKind kind) {
        for (auto& object : list) {
            if (object.id == id) visit(object, kind);
        }
    };
    if (scene.room && scene.room->id == id) visit(*scene.room, ObjectKind::room);
    if (scene.room) search(scene.room->sub_areas, ObjectKind::sub_area);
    search(scene.furniture, ObjectKind::furniture);
    search(scene.surfaces, ObjectKind::surface);
    search(scene.luminaires, ObjectKind::luminaire);
    search(scene.grids, ObjectKind::grid);
    search(scene.points, ObjectKind::point);
    search(scene.views, ObjectKind::view);
    search(scene.materials, ObjectKind::material);
    search(scene.control_groups, ObjectKind::control_group);
    search(scene.light_scenes, ObjectKind::light_scene);
    search(scene.arrangements, ObjectKind::arrangement);
    search(scene.object_groups, ObjectKind::object_group);
}

}  // namespace hanei
