/// Where, around a place of a face, its patches lie.
#pragma once

#include "engine/mesh/mesh.h"

namespace hanei {

struct FreeSector {
    double angle = 0.0;  ///< rad that patches fill around the place: 2 pi inside the face, 0 beside it
    Vec3 inward{0.0};    ///< unit, the middle of it; zero when the place is not on a border
};

/// Needs     a place in the plane of the face. Patches within `same_place` of it count as touching.
/// Cost      a look at every patch of the face.
FreeSector free_sector(const Mesh& mesh, const MeshFace& face, const Vec3& place, double same_place);

/// The diameter of everything meshed.
double diameter_of(const Mesh& mesh);

}  // namespace hanei
