/// Vectors of the house: double precision, metres unless a name says otherwise.
#pragma once

#include <glm/glm.hpp>

#include <vector>

namespace hanei {

using Vec2 = glm::dvec2;
using Vec3 = glm::dvec3;
using Mat3 = glm::dmat3;

/// A closed loop of points. The side from which it runs counter-clockwise is its front.
using Polygon = std::vector<Vec3>;

/// A planar polygon with holes. Holes run clockwise seen from the front.
struct Region {
    Polygon outline;
    std::vector<Polygon> holes;
    bool operator==(const Region&) const = default;
};

}  // namespace hanei
