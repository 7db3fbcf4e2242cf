/// What the exporter writes beside meshes and lights, so that a scene comes back as it was.
///
/// At the root, "extras": {"hanei": {"scene": 0, "project": {...}}}: the number of the scene that holds
/// the authored objects, and the project file's own content (project_file.h). At each
/// node "extras": {"hanei": {"kind": "furniture", "id": 7}}: kinds are room, furniture, surface and
/// luminaire, the id is the object's in the project. At each material "extras": {"hanei": {"id": 3,
/// "reflectance": 0.5, "tint": [1, 1, 1]}}.
///
/// What another program changes in the file wins over what stands there: gltf_own_objects.h says how for
/// meshes, place_own_luminaires() for luminaires, own_materials for colours. Everything else is as the
/// project has it: views, grids, groups, and what luminaires emit.
#pragma once

#include "engine/project/gltf_document.h"
#include "engine/project/gltf_nodes.h"
#include "engine/project/project_file.h"

#include <optional>
#include <string>

namespace hanei {

struct GltfOwnNode {
    std::string kind;
    ObjectId id;
};

/// The node's own extras; an empty kind where there are none or no sound ones.
GltfOwnNode own_node(const GltfDocument& document, std::size_t node);

/// Errors for extras of nodes that are none, and for ids that name nothing of their kind in `own`.
void check_own_nodes(GltfDocument& document, const Scene* own);

/// The number of the authored scene; none in foreign files.
std::optional<std::size_t> own_scene(GltfDocument& document);

/// The project's part; none in foreign files.
/// Returns   errors for a part that could not stand in a project file. Its photometries name no files.
std::optional<Project> own_project(GltfDocument& document);

/// Leaves luminaires where their nodes stand, and those without a node out; a copy of a node is a copy of
/// its luminaire. A node that agrees with the luminaire's own place up to single precision changes nothing.
/// Its opening and what it emits are the luminaire's own, whatever the node shows.
void place_own_luminaires(GltfDocument& document, const std::vector<GltfNode>& nodes, Scene& scene);

/// Says that these objects are left out because no node shows them any more; nothing of none.
void tell_gone(GltfDocument& document, const std::vector<std::string>& names);

}  // namespace hanei
