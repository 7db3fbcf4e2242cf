#include "engine/mesh/free_sector.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <span>

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

struct Extent {
    Vec3 low{std::numeric_limits<double>::infinity()};
    Vec3 high{-std::numeric_limits<double>::infinity()};

    void take_in(std::span<const Vec3> places) {
        for (const Vec3& place : places) {
            low = glm::min(low, place);
            high = glm::max(high, place);
        }
    }
};

bool may_touch(const Patch& patch, const Vec3& place, double same_place) {
    Extent extent;
    extent.take_in(patch.outline);
    const Vec3 beyond = glm::max(extent.low - place, place - extent.high);
    return std::max({beyond.x, beyond.y, beyond.z}) <= same_place;
}

/// What patches fill around a place, one after the other.
class Filled {
public:
    Filled(const Vec3& normal, const Vec3& place, double same_place)
        : normal_(normal), place_(place), same_place_(same_place) {}

    void add(const Patch& patch) {
        if (!may_touch(patch, place_, same_place_)) return;
        const Sector sector = sector_of(patch, normal_, place_, same_place_);
        angle_ += sector.angle;
        sum_ += 2.0 * std::sin(0.5 * sector.angle) * sector.middle;  // the integral of all its directions
        if (sector.angle > widest_.angle) widest_ = sector;
    }

    FreeSector sector() const {
        constexpr double closed = 2.0 * std::numbers::pi - 1e-6;  // angles between corners 1e-9 of the room apart
        if (angle_ <= 0.0 || angle_ >= closed) return {angle_, Vec3(0.0)};
        const double length = glm::length(sum_);
        return {angle_, length > 1e-3 ? sum_ / length : widest_.middle};  // opposite sectors cancel: take one of them
    }

private:
    Vec3 normal_, place_;
    double same_place_, angle_ = 0.0;
    Vec3 sum_{0.0};
    Sector widest_;
};

}  // namespace

FreeSector free_sector(const Mesh& mesh, const MeshFace& face, const Vec3& place, double same_place) {
    Filled filled(face.face.normal, place, same_place);
    for (std::uint32_t k = 0; k < face.patch_count; ++k) filled.add(mesh.patches[face.first_patch + k]);
    return filled.sector();
}

SectorFinder::SectorFinder(const Mesh& mesh, const MeshFace& face) : mesh_(mesh), face_(face) {
    Extent all;
    all.take_in(face.face.region.outline);
    const Vec3 size = all.high - all.low;
    if (size.y > size.x) axis_ = 1;
    if (size.z > size[axis_]) axis_ = 2;
    beginnings_.reserve(face.patch_count);
    for (std::uint32_t p = face.first_patch; p < face.first_patch + face.patch_count; ++p) {
        Extent extent;
        extent.take_in(mesh.patches[p].outline);
        beginnings_.push_back({extent.low[axis_], p});
        widest_ = std::max(widest_, extent.high[axis_] - extent.low[axis_]);
    }
    std::sort(beginnings_.begin(), beginnings_.end(),
              [](const Beginning& a, const Beginning& b) { return a.low < b.low; });
}

FreeSector SectorFinder::at(const Vec3& place, double same_place) const {
    const double from = place[axis_] - widest_ - same_place;
    auto next = std::lower_bound(beginnings_.begin(), beginnings_.end(), from,
                                 [](const Beginning& beginning, double low) { return beginning.low < low; });
    std::vector<std::uint32_t> touching;
    for (; next != beginnings_.end() && next->low <= place[axis_] + same_place; ++next)
        if (may_touch(mesh_.patches[next->patch], place, same_place)) touching.push_back(next->patch);
    std::sort(touching.begin(), touching.end());  // sums in the order of the patches: the same bits always
    Filled filled(face_.face.normal, place, same_place);
    for (const std::uint32_t patch : touching) filled.add(mesh_.patches[patch]);
    return filled.sector();
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
