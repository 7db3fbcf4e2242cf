/// The lights of a glTF 2.0 file: KHR_lights_punctual and EXT_lights_ies.
#pragma once

#include "engine/base/vector.h"
#include "engine/project/gltf_document.h"
#include "engine/project/gltf_nodes.h"
#include "engine/project/luminaires.h"

#include <string_view>
#include <vector>

namespace hanei {

/// A luminaire where the file hangs it, in the house's axes: z up, x as in the file. Its nadir is its
/// node's -Z and its plane 0 the node's +X, both unit vectors square to each other; aim() takes them.
struct GltfLight {
    NamedPhotometry luminaire;
    Vec3 position{0.0};
    Vec3 nadir{0.0, 0.0, -1.0};
    Vec3 plane_0{1.0, 0.0, 0.0};
};

struct GltfRead {
    std::vector<GltfLight> lights;
    Diagnostics findings;
};

/// Every light of these nodes, named by its node. One with a profile hangs once: the point or spot light at
/// its node stands for it in programs that know no profiles. Scale moves lights but changes
/// no intensity. Point and spot lights become tables (gltf_punctual.h), profiles are read by the reader
/// of luminaire files and multiplied by their node's factor. Colour and range are not photometry: a
/// warning of the luminaire says that they are left out. Directional lights have neither place nor
/// candela: a warning says that they are left out.
///
/// Returns   the lights that are sound; an error for each that is not. At most 1000 lights and 20 million
///           intensities: a warning says when there are more.
std::vector<GltfLight> placed_lights(GltfDocument& document, const std::vector<GltfNode>& nodes);

/// The lights of the scene that the file shows first; an error for a file without any.
GltfRead read_gltf(std::string_view bytes, std::string_view name, const GltfNeighbour& neighbour = {});

}  // namespace hanei
