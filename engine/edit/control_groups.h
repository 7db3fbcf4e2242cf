/// Control groups: luminaires that are dimmed together.
#pragma once

#include "engine/scene/dimmers.h"

#include <string>

namespace hanei {

/// The group of this name, made when there is none yet; no group for an empty name.
ObjectId control_group_named(Scene& scene, const std::string& name);

}  // namespace hanei
