/// The triangles of a glTF scene where its nodes place them.
#pragma once

#include "engine/base/vector.h"
#include "engine/project/gltf_document.h"
#include "engine/project/gltf_nodes.h"

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

namespace hanei {

/// One primitive of one node: what has one material.
struct GltfPrimitive {
    std::size_t node = 0;
    std::optional<std::size_t> material;
    std::vector<Vec3> vertices;                           ///< in the file's axes and unit, where the node places them
    std::vector<std::array<std::uint32_t, 3>> triangles;  ///< counter-clockwise from the front; mirrored nodes turned
};

inline constexpr std::size_t most_gltf_triangles = 300'000;  ///< of a whole scene

/// The primitives of these nodes, in their order. Triangles, strips and fans; with a warning each that
/// counts them, points and lines, skins, morph targets and vertex colours are left out.
///
/// Returns   what is sound; an error for every index that counts nothing, byte outside its buffer, place
///           that is not finite or farther than `farthest` from the origin, and for a scene of more
///           triangles than are read.
std::vector<GltfPrimitive> placed_primitives(GltfDocument& document, const std::vector<GltfNode>& nodes,
                                             double farthest);

/// An error for every extension without which the file's geometry cannot be read.
void check_required_extensions(GltfDocument& document);

}  // namespace hanei
