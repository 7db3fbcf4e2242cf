/// What the exporter writes beside meshes and lights, so that a scene comes back as it was.
///
/// At the root, "extras": {"hanei": {"scene": 0, "project": {...}}}: the scene that holds the authored
/// objects, and of the project file the parts that no mesh can hold: materials, room, luminaires and
/// their photometries, control groups, calculation grids and points, views. At each node
/// "extras": {"hanei": {"kind": "room"}}; kinds are room, furniture, surface ("exitance_lm_m2") and
/// luminaire ("id" in the project's part).
#pragma once

#include "engine/project/gltf_document.h"
#include "engine/project/gltf_nodes.h"
#include "engine/scene/scene.h"

#include <optional>
#include <string>

namespace hanei {

struct GltfOwnNode {
    std::string kind;
    ObjectId luminaire;
    LuminousExitance own_exitance;
};

/// The node's own extras; an empty kind where there are none.
GltfOwnNode own_node(GltfDocument& document, std::size_t node);

/// The number of the authored scene; none in foreign files.
std::optional<std::size_t> own_scene(GltfDocument& document);

/// The project's part, its room and luminaires still as they were written; none in foreign files.
/// Returns   errors for a part that could not stand in a project file.
std::optional<Scene> own_project(GltfDocument& document);

/// Leaves luminaires where their nodes stand, and those without a node out. A node that agrees with the
/// luminaire's own place up to single precision changes nothing.
void place_own_luminaires(GltfDocument& document, const std::vector<GltfNode>& nodes, Scene& scene);

}  // namespace hanei
