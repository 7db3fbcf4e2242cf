/// The nodes of a glTF scene and where they stand.
#pragma once

#include "engine/project/json_fields.h"

#include <glm/mat4x4.hpp>

#include <cstddef>
#include <optional>
#include <vector>

namespace hanei {

struct GltfNode {
    std::size_t number = 0;
    glm::dmat4 to_world{1.0};           ///< in the file's axes: y up
    std::optional<std::size_t> parent;  ///< its number; none: the scene lists it
};

/// The nodes of the scene that the file shows first, or of scenes[scene], parents before their children,
/// in the file's order.
///
/// Needs     a scene that the file holds.
///
/// Returns   none, with an error, when an index counts no node, a node has two parents or is its own
///           ancestor, or a transformation is not finite.
/// Cost      linear in the nodes; no recursion.
std::vector<GltfNode> placed_nodes(JsonReading& reading, const JsonValue& root, std::optional<std::size_t> scene = {});

}  // namespace hanei
