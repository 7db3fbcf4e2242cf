/// A closed shell of a foreign file as the room itself.
#pragma once

#include "engine/project/mesh_shapes.h"

#include <optional>

namespace hanei {

/// A plan extruded upright, if that is what the shell is: a level floor, a level ceiling above it of the
/// same outline, and an upright wall a side. Each face is of the material that covers most of it.
///
/// Returns   none for a shell of any other shape. Its id is left to the caller.
std::optional<Room> room_of(const TriangleShell& shell, const MeshObject& object,
                            const std::vector<GltfMaterial>& materials);

/// Which shell is the room. Of those that look inward the one of most volume, else of those that look
/// outward; with `asked` any closed one will do, otherwise it must be as large as a room, and look inward
/// or hold everything else: all other shells and `places`, of which there must be some.
/// Returns   its number; none when there is none.
std::optional<std::size_t> room_among(const std::vector<const TriangleShell*>& shells, const std::vector<Vec3>& places,
                                      bool asked);

}  // namespace hanei
