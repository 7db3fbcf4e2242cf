#include "engine/project/gltf_agreement.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

namespace hanei {
namespace {

std::vector<Vec3> corners_of(const TriangleSoup& soup) {
    std::vector<Vec3> corners;
    for (const Triangle& triangle : soup.triangles)
        for (const int vertex : triangle.corner) corners.push_back(soup.vertices[static_cast<std::size_t>(vertex)]);
    return corners;
}

double farthest_of(const std::vector<Vec3>& places) {
    double farthest = 0.0;
    for (const Vec3& place : places)
        farthest = std::max({farthest, std::abs(place.x), std::abs(place.y), std::abs(place.z)});
    return farthest;
}

/// Places by the cubes of a grid they lie in.
class Cubes {
public:
    Cubes(const std::vector<Vec3>& places, double near) : near_(near) {
        for (const Vec3& place : places) filled_[cube_of(place)].push_back(place);
    }

    bool has_near(const Vec3& place) const {
        std::set<Cube> around;
        for (int corner = 0; corner < 8; ++corner) {
            const auto side = [&](int bit) { return (corner >> bit & 1) == 0 ? -near_ : near_; };
            around.insert(cube_of(place + Vec3{side(0), side(1), side(2)}));
        }
        return std::any_of(around.begin(), around.end(), [&](const Cube& cube) {
            const auto found = filled_.find(cube);
            return found != filled_.end() &&
                   std::any_of(found->second.begin(), found->second.end(),
                               [&](const Vec3& other) { return glm::distance(place, other) <= near_; });
        });
    }

private:
    using Cube = std::array<double, 3>;
    Cube cube_of(const Vec3& place) const {
        const double side = 100.0 * near_;
        return {std::floor(place.x / side), std::floor(place.y / side), std::floor(place.z / side)};
    }

    double near_;
    std::map<Cube, std::vector<Vec3>> filled_;
};

bool all_near(const std::vector<Vec3>& places, const std::vector<Vec3>& others, double near) {
    const Cubes cubes(others, near);
    return std::all_of(places.begin(), places.end(), [&](const Vec3& place) { return cubes.has_near(place); });
}

/// What the triangles of one label add up to, whatever their order.
struct Moments {
    double area = 0.0, volume = 0.0, edges = 0.0;
    Vec3 vector{0.0};
};

std::map<int, Moments> moments_of(const TriangleSoup& soup, const Vec3& origin) {
    std::map<int, Moments> all;
    for (const Triangle& triangle : soup.triangles) {
        Moments& sum = all[triangle.label];
        const auto corner = [&](std::size_t k) {
            return soup.vertices[static_cast<std::size_t>(triangle.corner[k])] - origin;
        };
        const Vec3 area = vector_area(soup.vertices, triangle);
        sum.area += glm::length(area);
        sum.vector += area;
        sum.volume += glm::dot(corner(0), area) / 3.0;
        for (std::size_t k = 0; k < 3; ++k) sum.edges += glm::distance(corner(k), corner((k + 1) % 3));
    }
    return all;
}

/// Up to places that are off by `rounding` each, in a body of this size.
bool are_alike(const Moments& a, const Moments& b, double rounding, double size) {
    const double of_area = rounding * (a.edges + b.edges);
    return std::abs(a.area - b.area) <= of_area && glm::distance(a.vector, b.vector) <= of_area &&
           std::abs(a.volume - b.volume) <= of_area * size + rounding * (a.area + b.area);
}

}  // namespace

void append(TriangleSoup& soup, const TriangleList& list, const Placement& placed, ObjectId material) {
    const auto first = static_cast<int>(soup.vertices.size());
    for (const Vec3& place : list.places) soup.vertices.push_back(placed.point(place));
    for (std::size_t k = 2; k < list.corners.size(); k += 3) {
        const auto corner = [&](std::size_t which) { return first + static_cast<int>(list.corners[which]); };
        soup.triangles.push_back({{corner(k - 2), corner(k - 1), corner(k)}, static_cast<int>(material.value)});
    }
}

bool show_the_same(const TriangleSoup& a, const TriangleSoup& b) {
    if (a.triangles.empty() || b.triangles.empty()) return a.triangles.empty() && b.triangles.empty();
    const std::vector<Vec3> corners = corners_of(a), others = corners_of(b);
    const double farthest = std::max(farthest_of(corners), farthest_of(others));
    const double rounding = 5e-7 * (1.0 + farthest);
    const double near = 1e-5 + rounding;
    if (!all_near(corners, others, near) || !all_near(others, corners, near)) return false;
    Vec3 low = corners[0], high = low;
    for (const Vec3& corner : corners) {
        low = glm::min(low, corner);
        high = glm::max(high, corner);
    }
    std::map<int, Moments> left = moments_of(a, low), right = moments_of(b, low);
    for (const auto& [label, moments] : left) right.try_emplace(label);
    return std::all_of(right.begin(), right.end(), [&](const auto& each) {
        return are_alike(left[each.first], each.second, rounding, glm::distance(low, high));
    });
}

}  // namespace hanei
