#include "engine/mesh/free_sector.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace hanei {

namespace {

struct Sector {
    double angle = 0.0;
    Vec3 middle{0.0};  ///< unit
};

/// The sector a convex polygon fills around a place; no angle when it does not touch the place.
Sector sector_of(const Patch& patch, const Vec3& normal, const Vec3& place, double same_place) {
    Sector sector{2.0 * std::numbers::pi, Vec3(0.0)};
    const std::size_t count = patch.outline.size();
    for (std::size_t k = 0; k < count; ++k) {
        const Vec3& a = patch.outline[k];
        const Vec3& b = patch.outline[(k + 1) % count];
        if (glm::length(a - place) <= same_place) {  // at a corner
            const Vec3 leaving = glm::normalize(b - a);
            const Vec3 coming = glm::normalize(patch.outline[(k + count - 1) % count] - a);
            const double angle = std::atan2(glm::dot(glm::cross(leaving, coming), normal), glm::dot(leaving, coming));
            const Vec3 middle = leaving + coming;
            const double length = glm::length(middle);
            return {std::max(0.0, angle), length > 1e-6 ? middle / length : glm::cross(normal, leaving)};
        }
        const Vec3 left = glm::cross(normal, glm::normalize(b - a));
        const double inside = glm::dot(place - a, left);
        if (inside < -same_place) return {};
        if (inside <= same_place) sector = {std::numbers::pi, left};
    }
    return sector;
}

bool may_touch(const Patch& patch, const Vec3& place, double same_place) {
    Vec3 low(std::numeric_limits<double>::infinity());
    Vec3 high = -low;
    for (const Vec3& corner : patch.outline) {
        low = glm::min(low, corner);
        high = glm::max(high, corner);
    }
    const Vec3 beyond = glm::max(low - place, place - high);
    return std::max({beyond.x, beyond.y, beyond.z}) <= same_place;
}

}  // namespace

FreeSector free_sector(const Mesh& mesh, const MeshFace& face, const Vec3& place, double same_place) {
    FreeSector found;
    Vec3 sum(0.0);
    Sector widest;
    for (std::uint32_t k = 0; k < face.patch_count; ++k) {
        const Patch& patch = mesh.patches[face.first_patch + k];
        if (!may_touch(patch, place, same_place)) continue;
        const Sector sector = sector_of(patch, face.face.normal, place, same_place);
        found.angle += sector.angle;
        sum += 2.0 * std::sin(0.5 * sector.angle) * sector.middle;  // the integral of all its directions
        if (sector.angle > widest.angle) widest = sector;
    }
    constexpr double closed = 2.0 * std::numbers::pi - 1e-6;  // angles between corners 1e-9 of the room apart
    if (found.angle <= 0.0 || found.angle >= closed) return found;
    const double length = glm::length(sum);
    found.inward = length > 1e-3 ? sum / length : widest.middle;  // opposite sectors cancel: take one of them
    return found;
}

double diameter_of(const Mesh& mesh) {
    Vec3 low(std::numeric_limits<double>::infinity());
    Vec3 high = -low;
    for (const MeshFace& face : mesh.faces) {
        for (const Vec3& corner : face.face.region.outline) {
            low = glm::min(low, corner);
            high = glm::max(high, corner);
        }
    }
    return mesh.faces.empty() ? 0.0 : glm::length(high - low);
}

}  // namespace hanei
