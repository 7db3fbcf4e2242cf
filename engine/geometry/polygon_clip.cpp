#include "engine/geometry/polygon.h"

#include <cmath>

namespace hanei {

namespace {

double snapped_height(const Plane& plane, const Vec3& point, double thickness) {
    const double height = plane.height(point);
    return std::abs(height) <= thickness ? 0.0 : height;
}

/// Narrower than `thickness`: the width of a convex polygon is at least its area over its diameter.
bool is_sliver(const Polygon& polygon, double thickness) {
    return polygon.size() < 3 || glm::length(vector_area(polygon)) <= 0.5 * thickness * diameter(polygon);
}

}  // namespace

Polygon clipped(const Polygon& polygon, const Plane& plane, double thickness) {
    Polygon kept;
    bool in_front = false;
    for (std::size_t k = 0; k < polygon.size(); ++k) {
        const Vec3& a = polygon[k];
        const Vec3& b = polygon[(k + 1) % polygon.size()];
        const double height_a = snapped_height(plane, a, thickness);
        const double height_b = snapped_height(plane, b, thickness);
        in_front = in_front || height_a > 0.0;
        if (height_a >= 0.0) kept.push_back(a);
        if ((height_a > 0.0 && height_b < 0.0) || (height_a < 0.0 && height_b > 0.0)) {
            kept.push_back(a + (height_a / (height_a - height_b)) * (b - a));
        }
    }
    if (!in_front || kept.size() < 3) kept.clear();
    return kept;
}

std::vector<Polygon> subtracted(const Polygon& whole, const Polygon& cutter, double thickness, Polygon* inside) {
    std::vector<Polygon> pieces;
    Polygon rest = whole;
    const Vec3 normal = unit_normal(cutter);
    for (std::size_t k = 0; k < cutter.size() && !rest.empty(); ++k) {
        const Vec3 along = cutter[(k + 1) % cutter.size()] - cutter[k];
        const double length = glm::length(along);
        if (length == 0.0) continue;
        const Vec3 outward = glm::cross(along / length, normal);
        Polygon outside = clipped(rest, {cutter[k], outward}, thickness);
        if (!is_sliver(outside, thickness)) pieces.push_back(std::move(outside));
        rest = clipped(rest, {cutter[k], -outward}, thickness);
    }
    if (normal == Vec3{0.0} || is_sliver(rest, thickness)) rest.clear();
    if (rest.empty()) pieces.assign(1, whole);
    if (inside) *inside = std::move(rest);
    return pieces;
}

}  // namespace hanei
