#include "engine/geometry/convex_hull.h"

#include <algorithm>
#include <cmath>

namespace hanei {

namespace {

struct Placed {
    Vec2 flat;
    std::size_t number;
};

double turn(const Vec2& a, const Vec2& b, const Vec2& c) {
    return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

/// Adds a corner to one half of the hull; corners that it makes superfluous leave.
void add(std::vector<Placed>& chain, std::size_t keep, const Placed& next) {
    while (chain.size() >= keep + 2 && turn(chain[chain.size() - 2].flat, chain.back().flat, next.flat) <= 0.0)
        chain.pop_back();
    chain.push_back(next);
}

}  // namespace

Polygon convex_hull(std::span<const Vec3> points, const Vec3& normal) {
    if (points.size() < 3) return {};
    const Vec3 helper = std::abs(normal.x) < 0.7 ? Vec3{1.0, 0.0, 0.0} : Vec3{0.0, 1.0, 0.0};
    const Vec3 x = glm::normalize(glm::cross(helper, normal));
    const Vec3 y = glm::cross(normal, x);
    std::vector<Placed> placed;
    placed.reserve(points.size());
    for (std::size_t k = 0; k < points.size(); ++k) {
        const Vec3 from_first = points[k] - points[0];
        placed.push_back({{glm::dot(from_first, x), glm::dot(from_first, y)}, k});
    }
    std::ranges::sort(placed, [](const Placed& a, const Placed& b) {
        return a.flat.x < b.flat.x || (a.flat.x == b.flat.x && a.flat.y < b.flat.y);
    });
    std::vector<Placed> chain;
    for (const Placed& next : placed) add(chain, 0, next);
    const std::size_t below = chain.size() - 1;
    for (auto next = placed.rbegin() + 1; next != placed.rend(); ++next) add(chain, below, *next);
    chain.pop_back();  // the first again
    Polygon hull;
    for (const Placed& corner : chain) hull.push_back(points[corner.number]);
    return hull.size() < 3 ? Polygon{} : hull;
}

}  // namespace hanei
