/// What of a scene is hard to compute, and what becomes of it here.
#pragma once

#include "engine/base/diagnostic.h"
#include "engine/scene/scene.h"

#include <string>

namespace hanei {

/// Notes, no faults: each says in a sentence or two what was found, what a simple method would make of it,
/// what this program does, and what the user may do. Bodies thinner than a millimetre, that touch or leave
/// a gap of less; sheets listed twice, overlapping in one plane or meeting at a sharp angle; slivers;
/// luminaires flush with a wall or reaching through it, touching or hiding others, with a body right before
/// them, of hardly any extent; points in the plane of a source, close to it, in a corner of the room, by the
/// edge of a hard shadow; plans that are not convex; reflectances that keep nearly all light, or none; scenes
/// without light or without a room, tiny, huge or far from the origin; a great many bodies.
///
/// Needs     a scene without errors (check_scene).
/// Cost      pairs of bodies and of sheets are looked at along one axis: some milliseconds for a thousand.
Diagnostics hard_spots(const Scene& scene);

/// How many of each there are: "no errors; 3 notes", "1 error, 2 warnings", "nothing to complain about".
std::string verdict_of(const Diagnostics& findings);

}  // namespace hanei
