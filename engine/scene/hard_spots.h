/// What of a scene is hard to compute, and what becomes of it here.
#pragma once

#include "engine/base/diagnostic.h"
#include "engine/scene/scene.h"

namespace hanei {

/// Notes, no faults: each says in a sentence or two what was found, what a simple method would make of it,
/// what this program does, and what the user may do. Bodies thinner than a millimetre, that touch or leave
/// a gap of less; sheets listed twice or overlapping in one plane; slivers; luminaires flush with a wall or
/// reaching through it; points in the plane of a luminous opening; reflectances that keep nearly all light;
/// scenes without a room, tiny, huge or far from the origin; a great many bodies.
///
/// Needs     a scene without errors (check_scene).
/// Cost      pairs of bodies and of sheets are looked at along one axis: some milliseconds for a thousand.
Diagnostics hard_spots(const Scene& scene);

}  // namespace hanei
