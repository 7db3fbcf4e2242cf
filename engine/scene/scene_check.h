/// Finds what is wrong with a scene, each fault with its object and what to do.
#pragma once

#include "engine/base/diagnostic.h"
#include "engine/scene/scene.h"

namespace hanei {

/// Errors make a scene unfit to be solved: figures that are not finite, reflectance outside 0 to 1,
/// a plan that crosses itself, solids that are not closed and convex, missing materials, ...
/// Warnings leave it solvable: reversed normals, faces without area, luminaires outside the room or
/// inside furniture, reflectance 1 in a closed room, overlapping solids, ...
/// Place::field names the field, Place::object the object; file and line stay empty.
Diagnostics check_scene(const Scene& scene);

}  // namespace hanei
