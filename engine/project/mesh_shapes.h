/// Triangles of one object of a foreign file as what the scene holds: solids and free surfaces.
#pragma once

#include "engine/base/diagnostic.h"
#include "engine/geometry/triangle_shells.h"
#include "engine/project/gltf_material.h"
#include "engine/scene/scene.h"

#include <string>
#include <utility>
#include <vector>

namespace hanei {

/// Triangles in metres, z up, their labels numbers of materials.
///
/// Holds     what is needed to say what was done to it.
struct MeshObject {
    std::string name;
    double distance = 0.0;  ///< m: places nearer to each other are one
    SoupRepairs repairs;
    std::vector<TriangleShell> shells;
};

/// Welds the triangles and sorts them into shells. `distance` 0: a hundred thousandth of the object's
/// diameter, or what single precision leaves so far from the origin if that is more.
MeshObject mesh_object(std::string name, TriangleSoup soup, double distance);

struct MeshSolid {
    SolidShape shape;  ///< in the scene's coordinates
    ObjectId material;
};

struct MeshShapes {
    std::vector<MeshSolid> solids;
    std::vector<FreeSurface> sheets;
    std::vector<std::pair<Severity, std::string>> remarks;  ///< sentences about what had to be done
};

/// Closed shells become solids, turned outward, of the material that covers most of each; those of a
/// material that shines, and what is open, become free surfaces, one a flat face, both sides where the
/// material says so. A closed shell inside another that faces it is a hollow nobody sees into: left out.
///
/// Needs     materials for all labels, with their ids; every solid and sheet then passes check_scene.
/// Returns   sheets named after the object, numbered when there are several.
MeshShapes shapes_of(const MeshObject& object, const std::vector<GltfMaterial>& materials);

/// The faces of a closed shell as free surfaces that are seen from inside.
std::vector<FreeSurface> inward_sheets(const TriangleShell& shell, const MeshObject& object,
                                       const std::vector<GltfMaterial>& materials);

}  // namespace hanei
