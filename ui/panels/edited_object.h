/// How a property panel edits one object of a list.
#pragma once

#include "engine/scene/scene.h"

#include <optional>
#include <vector>

namespace hanei {

/// Edits a copy of the object of this id; the scene with it in place when `rows` changed it.
template <class Object, class Rows>
std::optional<Scene> edited(const Scene& scene, std::vector<Object> Scene::*list, ObjectId id, const Rows& rows) {
    const std::vector<Object>& objects = scene.*list;
    for (std::size_t k = 0; k < objects.size(); ++k) {
        if (objects[k].id != id) continue;
        Object object = objects[k];
        if (!rows(object)) return std::nullopt;
        Scene wished = scene;
        (wished.*list)[k] = std::move(object);
        return wished;
    }
    return std::nullopt;
}

}  // namespace hanei
