#include "engine/study/trust_rays.h"

#include "engine/geometry/polygon.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace hanei {
namespace {

constexpr double nowhere = std::numeric_limits<double>::infinity();

bool is_inside(const Polygon& piece, const Vec3& normal, const Vec3& place) {
    for (std::size_t k = 0; k < piece.size(); ++k) {
        const Vec3& corner = piece[k];
        const Vec3 edge = piece[(k + 1) % piece.size()] - corner;
        if (glm::dot(glm::cross(edge, place - corner), normal) < 0.0) return false;
    }
    return true;
}

/// Two unit vectors at right angles to the normal and to each other.
std::pair<Vec3, Vec3> across(const Vec3& normal) {
    const Vec3 other = std::abs(normal.x) < 0.5 ? Vec3{1.0, 0.0, 0.0} : Vec3{0.0, 1.0, 0.0};
    const Vec3 first = glm::normalize(glm::cross(normal, other));
    return {first, glm::cross(normal, first)};
}

}  // namespace

RaysFrom::RaysFrom(const Mesh& mesh, const OccluderSet* occluders, const std::set<std::uint32_t>& opaque) {
    for (const MeshFace& face : mesh.faces) walls_.push_back({convex_pieces(face.face.region), face.face.normal, true});
    double extent = 0.0;
    for (const Patch& patch : mesh.patches) extent = std::max(extent, glm::length(patch.centre));
    same_place_ = std::max(1e-9 * extent, occluders ? 4.0 * occluders->same_place() : 0.0);
    if (!occluders) return;
    for (const ConvexBody& body : occluders->bodies()) {
        if (!opaque.contains(body.owner)) continue;
        for (const std::vector<int>& corners : body.faces) {
            Polygon polygon;
            for (const int corner : corners) polygon.push_back(body.vertices[static_cast<std::size_t>(corner)]);
            const Vec3 normal = unit_normal(polygon);
            walls_.push_back({{std::move(polygon)}, normal, false});
        }
    }
}

double RaysFrom::distance(const Wall& wall, const Vec3& from, const Vec3& direction) {
    if (wall.pieces.empty()) return nowhere;
    const double towards = glm::dot(direction, wall.normal);
    if (towards == 0.0) return nowhere;
    const double away = glm::dot(wall.pieces.front().front() - from, wall.normal) / towards;
    if (!(away > 0.0)) return nowhere;
    const Vec3 place = from + away * direction;
    const bool met = std::any_of(wall.pieces.begin(), wall.pieces.end(),
                                 [&](const Polygon& piece) { return is_inside(piece, wall.normal, place); });
    return met ? away : nowhere;
}

bool RaysFrom::meets_a_surface(const Vec3& from, const Vec3& direction) const {
    double front = nowhere, other = nowhere, taken = nowhere;
    for (const Wall& wall : walls_) {
        const double away = distance(wall, from, direction);
        if (away <= same_place_) continue;  // where it starts
        double& nearest = !wall.reflects ? taken : glm::dot(direction, wall.normal) < 0.0 ? front : other;
        nearest = std::min(nearest, away);
    }
    // of a sheet with two fronts the one that looks this way is seen; a luminaire covers what it lies on
    return front < nowhere && front <= other + same_place_ && front + same_place_ < taken;
}

std::size_t RaysFrom::meeting_a_surface(const Receiver& from, std::size_t rays) const {
    const auto [x, y] = across(from.normal);
    // the two-dimensional sequence by the plastic number: even, and the same every time
    constexpr double first = 0.7548776662466927, second = 0.5698402909980532;
    std::size_t met = 0;
    for (std::size_t k = 0; k < rays; ++k) {
        const double n = static_cast<double>(k) + 0.5;
        const double u = n * first - std::floor(n * first), v = n * second - std::floor(n * second);
        const double radius = std::sqrt(u), angle = 2.0 * std::numbers::pi * v;
        const Vec3 direction =
            radius * std::cos(angle) * x + radius * std::sin(angle) * y + std::sqrt(1.0 - u) * from.normal;
        if (meets_a_surface(from.position, direction)) ++met;
    }
    return met;
}

}  // namespace hanei
