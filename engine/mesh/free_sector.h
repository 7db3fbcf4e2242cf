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

/// The same at many places of one face.
///
/// Needs     a mesh and face that outlive it and do not change.
/// Cost      n log n to make it for n patches; a place looks at those that begin no further before it than
///           the widest reaches: about the root of n on a grid.
class SectorFinder {
public:
    SectorFinder(const Mesh& mesh, const MeshFace& face);

    FreeSector at(const Vec3& place, double same_place) const;

private:
    struct Beginning {
        double low = 0.0;  ///< along the axis
        std::uint32_t patch = 0;
    };

    const Mesh& mesh_;
    const MeshFace& face_;
    glm::length_t axis_ = 0;             ///< x, y or z: the face's longest
    double widest_ = 0.0;                ///< of any patch along it
    std::vector<Beginning> beginnings_;  ///< ascending
};

/// The diameter of everything meshed.
double diameter_of(const Mesh& mesh);

}  // namespace hanei
