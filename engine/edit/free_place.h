/// Where there is room for one more thing.
#pragma once

#include "engine/scene/faces.h"

namespace hanei {

/// A place on the floor for something with these bounds about its own origin, unturned: within the plan,
/// clear of furniture, as near to the plan's middle as such a place is found on a raster of 0.2 m.
///
/// Returns   the middle of the plan when the room is full. Without a room, beside what stands there.
Vec3 free_place(const Scene& scene, const Bounds& own);

}  // namespace hanei
