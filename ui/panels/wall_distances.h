/// How far chosen objects are from the walls around them.
#pragma once

#include "engine/edit/edit.h"

#include <span>
#include <vector>

namespace hanei {

struct WallDistance {
    int axis = 0;    ///< 0: to a wall along x, 1: along y
    Vec3 from{0.0};  ///< on the object
    Vec3 to{0.0};    ///< on the wall
    double metres() const { return glm::length(to - from); }
};

/// Left, right, front and back, each to the wall that is met first: from the middle of one luminaire, from
/// the sides of anything else. Nothing without a room, for what has no place in its plan, and towards
/// walls that it stands at.
std::vector<WallDistance> wall_distances(const Scene& scene, std::span<const ObjectId> chosen);

}  // namespace hanei
