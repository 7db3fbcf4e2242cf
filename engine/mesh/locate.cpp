#include "engine/base/tolerance.h"
#include "engine/geometry/polygon.h"
#include "engine/mesh/free_sector.h"

#include <cmath>

namespace hanei {

LocatedReceiver locate(const Mesh& mesh, const Vec3& position, const Vec3& normal) {
    const double same_place = tolerance::same_place * diameter_of(mesh);
    LocatedReceiver found{{position, normal, Vec3(0.0)}, -1};
    for (std::size_t f = 0; f < mesh.faces.size(); ++f) {
        const Face& face = mesh.faces[f].face;
        if (glm::dot(face.normal, normal) < 1.0 - tolerance::parallel) continue;
        if (std::abs(Plane{face.region.outline.front(), face.normal}.height(position)) > same_place) continue;
        const FreeSector sector = free_sector(mesh, mesh.faces[f], position, same_place);
        if (sector.angle <= 0.0) continue;
        found.face = static_cast<int>(f);
        found.receiver.inward = sector.inward;
        return found;
    }
    return found;
}

}  // namespace hanei
