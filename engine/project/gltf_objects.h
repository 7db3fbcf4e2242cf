/// The objects of a glTF scene: what its author moved as one.
#pragma once

#include "engine/project/gltf_meshes.h"
#include "engine/project/gltf_own.h"
#include "engine/project/mesh_shapes.h"

#include <functional>
#include <set>

namespace hanei {

/// From the file's axes and unit to the scene's.
struct GltfAxes {
    double metres_per_unit = 1.0;
    bool z_up = false;

    Vec3 direction(const Vec3& v) const { return z_up ? v : Vec3{v.x, -v.z, v.y}; }
    Vec3 place(const Vec3& v) const { return metres_per_unit * direction(v); }
};

struct GltfObject {
    std::string name;
    std::string path;  ///< "nodes[3]"
    int line = 0;
    GltfOwnNode own;
    Vec3 origin{0.0};                ///< m, the node's
    double rotation = 0.0;           ///< rad, the node's about the vertical
    std::vector<MeshObject> meshes;  ///< one; of the exporter's own furniture one a primitive
    bool named = false;              ///< by its node
    glm::dmat4 to_world{1.0};        ///< the node's, in the file's axes
    TriangleSoup shown{};            ///< of the exporter's own objects: all triangles as they are
};

/// Top-level nodes and those that the exporter wrote, each with all meshes below it that belong to no
/// other. A lone root without a mesh is looked into when
/// `look_into_root` or converters name their roots so ("Sketchfab_model").
///
/// Needs     nodes parents first, as placed_nodes() returns them; labels for all materials of primitives.
std::vector<GltfObject> gltf_objects(GltfDocument& document, const std::vector<GltfNode>& nodes,
                                     const std::vector<GltfPrimitive>& primitives, const GltfAxes& axes,
                                     const std::function<int(std::optional<std::size_t>)>& label_of,
                                     bool look_into_root, double weld);

}  // namespace hanei
