/// The faces of a scene in the scene's coordinates: what receives and reflects light.
#pragma once

#include "engine/scene/scene.h"

namespace hanei {

/// Which authored face this is. `face` counts within the object: room faces as in Room; furniture
/// parts one after another, each part's faces in order; 0 for a free surface.
struct SurfaceRef {
    ObjectId object;
    int face = 0;
    auto operator<=>(const SurfaceRef&) const = default;
};

/// Part of a face with a material of its own, in scene coordinates.
struct FaceArea {
    Polygon outline;  ///< convex
    ObjectId material;
    ObjectId sub_area;
};

struct Face {
    SurfaceRef ref;
    Region region;  ///< counter-clockwise seen from the lit side
    Vec3 normal;    ///< unit, towards the lit side
    Vec3 along;     ///< unit, in the face: the direction its grid runs in (the longest edge's)
    ObjectId material;
    LuminousExitance own_exitance;
    std::vector<FaceArea> areas;  ///< sub-areas, in order; the later one is seen
};

/// The closed surface of a part of furniture, of any shape, in scene coordinates.
struct Shell {
    ObjectId object;
    std::vector<Vec3> vertices;
    std::vector<std::vector<int>> faces;  ///< counter-clockwise seen from outside
    int first_face = 0;                   ///< SurfaceRef::face of faces[0]
};

/// A convex solid in scene coordinates: all that a shell encloses, or a part of it.
struct Solid {
    ObjectId object;
    std::vector<Vec3> vertices;
    std::vector<std::vector<int>> faces;  ///< counter-clockwise seen from outside; some may be cuts
    std::vector<int> surface;             ///< SurfaceRef::face of the shell's faces that lie on it
    std::size_t shell = 0;                ///< number of its shell: solids of one shell are one body
};

/// All reflecting faces: room, furniture, free surfaces, in that order. Faces without area are left out.
std::vector<Face> faces_of(const Scene& scene);

/// All parts of all furniture, in order.
std::vector<Shell> shells_of(const Scene& scene);

/// The same cut into convex solids that touch but do not overlap, in the order of their shells.
/// Shells that cannot be cut so (convex_cells) are left out: their faces stand for them.
std::vector<Solid> solids_of(const Scene& scene);

/// The material of a face or sub-area; null when the id names none.
const Material* find_material(const Scene& scene, ObjectId id);

/// Axis-aligned bounds of everything that has a place (room, furniture, surfaces, luminaires).
struct Bounds {
    Vec3 low{0.0};
    Vec3 high{0.0};
    double diameter() const { return glm::length(high - low); }
};
Bounds bounds_of(const Scene& scene);

}  // namespace hanei
