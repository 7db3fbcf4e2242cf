/// What lies under the pointer, without OpenGL.
#pragma once

#include "ui/view/camera.h"
#include "ui/view/view_options.h"

#include <optional>

namespace hanei {

/// A place on a lit surface and the light there, as the picture shows it: interpolated, fit for a
/// read-out that follows the pointer. Figures that are reported are gathered at the point itself.
struct SurfaceHit {
    Vec3 place{0.0};
    Vec3 normal{0.0, 0.0, 1.0};
    double distance = 0.0;   ///< m, from the ray's origin
    std::uint32_t face = 0;  ///< into Mesh::faces
    std::uint32_t cell = 0;  ///< into DisplayMesh::cells
    SurfaceRef surface;
    double direct = 0.0;          ///< lx
    double interreflected = 0.0;  ///< lx
    double unshadowed = 0.0;      ///< lx; 0 unless the display mesh has it
    double total() const { return direct + interreflected; }
};

/// The nearest surface whose lit side the ray meets; backs are looked through, and what the ray's
/// picture leaves out is not there, as in the picture. Nothing where furniture is cut before it.
/// Cost      linear in the cells: 0.5 ms for 20 000.
std::optional<SurfaceHit> hit(const Solution& solution, const Ray& ray);

/// Where a ray first meets a face of the room, of furniture or a free surface; backs are looked through.
struct FaceHit {
    Vec3 place{0.0};
    Vec3 normal{0.0, 0.0, 1.0};
};
std::optional<FaceHit> first_face(const Scene& scene, const Ray& ray);

/// The luminaire, furniture, free surface or calculation point under a picture position; the id of
/// nothing where there is only the room. Luminaires and points are caught a few pixels around, and
/// a luminaire is preferred to what lies behind it.
ObjectId pick(const Scene& scene, const Camera& camera, Vec2 at, double aspect);

}  // namespace hanei
