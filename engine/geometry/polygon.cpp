#include "engine/geometry/polygon.h"

#include "engine/base/tolerance.h"

#include <algorithm>
#include <cmath>

namespace hanei {

Vec3 vector_area(std::span<const Vec3> polygon) {
    Vec3 twice{0.0};
    for (std::size_t k = 2; k < polygon.size(); ++k) {
        twice += glm::cross(polygon[k - 1] - polygon[0], polygon[k] - polygon[0]);
    }
    return 0.5 * twice;
}

Vec3 vector_area(const Region& region) {
    Vec3 area = vector_area(region.outline);
    for (const Polygon& hole : region.holes) area += vector_area(hole);
    return area;
}

Vec3 unit_normal(std::span<const Vec3> polygon) {
    const Vec3 area = vector_area(polygon);
    const double size = glm::length(area);
    const double extent = diameter(polygon);
    if (!(size > tolerance::no_area * extent * extent)) return Vec3{0.0};
    return area / size;
}

Vec3 centroid(std::span<const Vec3> polygon) {
    if (polygon.empty()) return Vec3{0.0};
    const Vec3 normal = unit_normal(polygon);
    Vec3 moment{0.0};
    double area = 0.0;
    for (std::size_t k = 2; k < polygon.size(); ++k) {
        const Vec3 a = polygon[k - 1] - polygon[0];
        const Vec3 b = polygon[k] - polygon[0];
        const double twice = glm::dot(glm::cross(a, b), normal);
        moment += (a + b) * (twice / 3.0);
        area += twice;
    }
    if (area > 0.0) return polygon[0] + moment / area;
    Vec3 sum{0.0};
    for (const Vec3& point : polygon) sum += point - polygon[0];
    return polygon[0] + sum / static_cast<double>(polygon.size());
}

double diameter(std::span<const Vec3> points) {
    if (points.empty()) return 0.0;
    Vec3 low = points[0];
    Vec3 high = points[0];
    for (const Vec3& point : points) {
        low = glm::min(low, point);
        high = glm::max(high, point);
    }
    return glm::length(high - low);
}

double distance_from_plane(std::span<const Vec3> polygon) {
    const Vec3 normal = unit_normal(polygon);
    Vec3 middle{0.0};
    for (const Vec3& point : polygon) middle += (point - polygon[0]) / static_cast<double>(polygon.size());
    double farthest = 0.0;
    for (const Vec3& point : polygon) {
        farthest = std::max(farthest, std::abs(glm::dot(point - polygon[0] - middle, normal)));
    }
    return farthest;
}

bool is_convex(std::span<const Vec3> polygon, const Vec3& normal) {
    const std::size_t count = polygon.size();
    if (count < 3) return false;
    const double extent = diameter(polygon);
    double turned = 0.0;
    for (std::size_t k = 0; k < count; ++k) {
        const Vec3 before = polygon[(k + 1) % count] - polygon[k];
        const Vec3 after = polygon[(k + 2) % count] - polygon[(k + 1) % count];
        const double sine = glm::dot(glm::cross(before, after), normal);
        if (sine < -tolerance::same_place * extent * std::max(glm::length(before), glm::length(after))) return false;
        turned += std::atan2(sine, glm::dot(before, after));
    }
    return turned < 9.0;  // once around is 2 pi, twice (a star) 4 pi
}

namespace {

double side(const Vec2& a, const Vec2& b, const Vec2& p) {
    return (b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x);
}

bool between(const Vec2& a, const Vec2& b, const Vec2& on_line) { return glm::dot(on_line - a, on_line - b) <= 0.0; }

bool edges_touch(const Vec2& a, const Vec2& b, const Vec2& c, const Vec2& d) {
    const double ca = side(c, d, a), cb = side(c, d, b);
    const double ac = side(a, b, c), ad = side(a, b, d);
    if (ca == 0.0 && between(c, d, a)) return true;
    if (cb == 0.0 && between(c, d, b)) return true;
    if (ac == 0.0 && between(a, b, c)) return true;
    if (ad == 0.0 && between(a, b, d)) return true;
    return (ca > 0.0) != (cb > 0.0) && (ac > 0.0) != (ad > 0.0);
}

}  // namespace

double signed_area(std::span<const Vec2> polygon) {
    double twice = 0.0;
    for (std::size_t k = 0; k < polygon.size(); ++k) {
        const Vec2 a = polygon[k] - polygon[0];
        const Vec2 b = polygon[(k + 1) % polygon.size()] - polygon[0];
        twice += a.x * b.y - a.y * b.x;
    }
    return twice / 2.0;
}

bool is_simple(std::span<const Vec2> polygon) {
    const std::size_t count = polygon.size();
    if (count < 3) return false;
    for (std::size_t k = 0; k < count; ++k) {
        const Vec2& a = polygon[k];
        const Vec2& b = polygon[(k + 1) % count];
        const Vec2& c = polygon[(k + 2) % count];
        if (a == b) return false;
        if (side(a, b, c) == 0.0 && glm::dot(b - a, c - b) < 0.0) return false;  // turns back upon itself
        for (std::size_t j = k + 2; j < count; ++j) {
            if (k == 0 && j == count - 1) continue;
            if (edges_touch(a, b, polygon[j], polygon[(j + 1) % count])) return false;
        }
    }
    return true;
}

}  // namespace hanei
