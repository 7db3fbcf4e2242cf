/// What a place sees, by following rays: shares no code with form factors.
#pragma once

#include "engine/geometry/occluders.h"
#include "engine/mesh/mesh.h"

#include <set>

namespace hanei {

class RaysFrom {
public:
    /// `opaque`: owners of bodies that reflect nothing (luminaires).
    /// Needs     a mesh that outlives it.
    RaysFrom(const Mesh& mesh, const OccluderSet* occluders, const std::set<std::uint32_t>& opaque);

    /// Of so many rays spread by Lambert's law, those that first meet the front of a surface.
    /// Cost      some 5 ns a ray and face.
    std::size_t meeting_a_surface(const Receiver& from, std::size_t rays) const;

private:
    struct Wall {
        std::vector<Polygon> pieces;  ///< convex
        Vec3 normal;
        bool reflects = true;  ///< on its front
    };
    bool meets_a_surface(const Vec3& from, const Vec3& direction) const;
    static double distance(const Wall& wall, const Vec3& from, const Vec3& direction);

    std::vector<Wall> walls_;
    double same_place_ = 0.0;
};

}  // namespace hanei
