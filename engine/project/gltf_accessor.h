/// The figures of a glTF accessor: places and vertex numbers, of every component type, strided, sparse.
#pragma once

#include "engine/base/vector.h"
#include "engine/project/gltf_document.h"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace hanei {

inline constexpr int most_gltf_elements = 1'000'000;  ///< of one accessor: more is no furniture

/// accessors[index] of type VEC3; `path` is where the index stands. Single precision is taken as the
/// shortest decimal number that stands for it: 1.6 m and not 1.60000002 m.
///
/// Returns   none, with an error, when an index counts nothing, bytes lie outside their buffer view, a
///           figure is not finite, or the count is greater than most_gltf_elements.
/// Cost      linear; nothing is allocated before the bytes are known to be there.
std::optional<std::vector<Vec3>> read_places(GltfDocument& document, const JsonValue& index, const std::string& path);

/// accessors[index] of type SCALAR and whole numbers, each of which counts one of `vertices`.
std::optional<std::vector<std::uint32_t>> read_indices(GltfDocument& document, const JsonValue& index,
                                                       const std::string& path, std::size_t vertices);

}  // namespace hanei
