/// Luminous polygons of uniform exitance: a panel, a window, the faces of a luminous solid.
#pragma once

#include "engine/direct/obstacles.h"
#include "engine/geometry/configuration_factor.h"

#include <span>
#include <vector>

namespace hanei {

struct LuminousFace {
    Region region;
    double exitance = 0.0;  ///< lm/m2
};

class DiffuseSource {
public:
    /// `hide_each_other`: the faces are those of a solid that is not convex.
    DiffuseSource(std::vector<LuminousFace> faces, bool hide_each_other);

    double unobstructed(const Receiver& receiver) const;

    double obstructed(const Receiver& receiver, const Obstacles& obstacles) const;

    std::vector<Vec3> extent() const;  ///< corners of all faces

    struct Face {
        LuminousFace luminous;
        std::vector<Polygon> pieces;  ///< convex
        Vec3 front{0.0};
    };
    std::span<const Face> faces() const { return faces_; }
    bool hides_itself() const { return !own_.empty(); }

private:
    bool may_light(const Face& face, const Receiver& receiver) const;

    std::vector<Face> faces_;
    OccluderSet own_;
};

}  // namespace hanei
