#include "engine/mesh/pieces.h"

#include "engine/geometry/polygon.h"

namespace hanei {

std::vector<Polygon> pieces_of(const Region& region, const Vec3& normal) {
    if (region.holes.empty() && is_convex(region.outline, normal)) return {region.outline};
    return convex_pieces(region);
}

Polygon common_part(const Polygon& a, const Polygon& b, const Vec3& normal, double thickness) {
    Polygon left = a;
    for (std::size_t k = 0; k < b.size() && !left.empty(); ++k) {
        const Vec3 edge = b[(k + 1) % b.size()] - b[k];
        const double length = glm::length(edge);
        if (length <= thickness) continue;
        left = clipped(left, {b[k], glm::cross(normal, edge / length)}, thickness);
    }
    return left;
}

}  // namespace hanei
