/// Control groups: luminaires that are dimmed together.
#pragma once

#include "engine/scene/scene.h"

#include <string>

namespace hanei {

/// Null when the id names none.
const ControlGroup* find_control_group(const Scene& scene, ObjectId id);

/// The group of this name, made when there is none yet; no group for an empty name.
ObjectId control_group_named(Scene& scene, const std::string& name);

}  // namespace hanei
