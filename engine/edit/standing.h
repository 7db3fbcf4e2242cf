/// Where furniture stands: on the floor, clear of other things, against a wall.
#pragma once

#include "engine/edit/edit.h"

#include <span>

namespace hanei {

/// The piece with its back to the nearest wall and touching it, when no more than `within` m are between
/// them (or it reaches into the wall); turned so that its front looks into the room.
///
/// Returns   nothing without a room, for other objects, or when every wall is farther.
std::optional<Scene> against_wall(const Scene& scene, ObjectId piece, double within);

/// The piece turned so that its back looks to the nearest wall; it stays where it is.
std::optional<Scene> turned_to_wall(const Scene& scene, ObjectId piece);

/// These pieces and surfaces each lowered or raised so that their lowest point lies on the floor. What
/// stands on a piece that is among them does not follow.
Scene on_floor(Scene scene, std::span<const ObjectId> chosen);

/// Whether the piece lies within the room and shares no space with other furniture, as far as boxes
/// around their parts tell.
bool stands_clear(const Scene& scene, ObjectId piece);

}  // namespace hanei
