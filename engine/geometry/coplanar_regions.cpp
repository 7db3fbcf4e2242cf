#include "engine/geometry/coplanar_regions.h"

#include "engine/base/tolerance.h"
#include "engine/geometry/growing_loop.h"
#include "engine/geometry/polygon.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <set>

namespace hanei {
namespace {

constexpr std::size_t most_corners = 500;  // of one face: its test for crossings takes the square

std::uint64_t key_of(int from, int to) {
    return static_cast<std::uint64_t>(static_cast<std::uint32_t>(from)) << 32U | static_cast<std::uint32_t>(to);
}

bool is_sound_loop(const Polygon& loop) {
    if (loop.size() < 3) return false;
    const Vec3 normal = unit_normal(loop);
    if (normal == Vec3{0.0}) return false;
    return distance_from_plane(loop) <= tolerance::planar * diameter(loop) && is_simple(flattened(loop, normal));
}

/// The closed loops that directed edges form; none when one of them does not close.
std::vector<std::vector<int>> chained(const std::map<int, int>& next_of) {
    std::vector<std::vector<int>> loops;
    std::set<int> seen;
    for (const auto& [start, unused] : next_of) {
        if (seen.count(start) > 0) continue;
        std::vector<int>& loop = loops.emplace_back();
        int at = start;
        while (seen.insert(at).second) {
            loop.push_back(at);
            const auto next = next_of.find(at);
            if (next == next_of.end()) return {};
            at = next->second;
        }
        if (at != start) return {};
    }
    return loops;
}

}  // namespace

bool is_sound_face(const std::vector<Vec3>& vertices, const FlatFace& face) {
    const Polygon outline = polygon_of(vertices, face.loop);
    if (!is_sound_loop(outline)) return false;
    const Plane plane{outline[0], unit_normal(outline)};
    const double thickness = tolerance::planar * diameter(outline);
    return std::all_of(face.holes.begin(), face.holes.end(), [&](const std::vector<int>& loop) {
        const Polygon hole = polygon_of(vertices, loop);
        return is_sound_loop(hole) && glm::dot(unit_normal(hole), plane.normal) < 0.0 &&
               std::all_of(hole.begin(), hole.end(),
                           [&](const Vec3& corner) { return std::abs(plane.height(corner)) <= thickness; });
    });
}

CoplanarRegions::CoplanarRegions(const TriangleShell& shell, bool keep_labels)
    : shell_(shell), keep_labels_(keep_labels), by_area_(shell.triangles.size()), taken_(shell.triangles.size()) {
    for (std::size_t t = 0; t < shell.triangles.size(); ++t) {
        areas_.push_back(vector_area(shell.vertices, shell.triangles[t]));
        const auto& corner = shell.triangles[t].corner;
        for (std::size_t k = 0; k < 3; ++k) across_[key_of(corner[k], corner[(k + 1) % 3])] = static_cast<int>(t);
    }
    std::iota(by_area_.begin(), by_area_.end(), std::size_t{0});
    std::stable_sort(by_area_.begin(), by_area_.end(),
                     [&](std::size_t a, std::size_t b) { return glm::length(areas_[a]) > glm::length(areas_[b]); });
}

int CoplanarRegions::neighbour(std::size_t triangle, std::size_t side) const {
    const auto& corner = shell_.triangles[triangle].corner;
    const auto found = across_.find(key_of(corner[(side + 1) % 3], corner[side]));
    return found == across_.end() ? -1 : found->second;
}

std::optional<CoplanarRegions::Region> CoplanarRegions::next() {
    while (first_ < by_area_.size() && taken_[by_area_[first_]]) ++first_;
    if (first_ == by_area_.size()) return std::nullopt;
    constexpr double same_way = 0.99;  // of a small triangle's normal, which rounding tilts
    constexpr double share = 0.4;      // of what a face may leave its plane: its own plane differs a little
    const std::size_t seed = by_area_[first_];
    const auto corner = [&](std::size_t t, std::size_t k) {
        return shell_.vertices[static_cast<std::size_t>(shell_.triangles[t].corner[k])];
    };
    const Plane plane{corner(seed, 0), glm::normalize(areas_[seed])};
    Vec3 low = plane.point, high = plane.point;
    const auto include = [&](std::size_t t) {
        for (std::size_t k = 0; k < 3; ++k) {
            low = glm::min(low, corner(t, k));
            high = glm::max(high, corner(t, k));
        }
        taken_[t] = true;
    };
    const auto fits = [&](std::size_t t) {
        if (taken_[t] || (keep_labels_ && shell_.triangles[t].label != shell_.triangles[seed].label)) return false;
        if (glm::dot(areas_[t], plane.normal) < same_way * glm::length(areas_[t])) return false;
        const double thickness = share * tolerance::planar * glm::distance(low, high);
        return std::abs(plane.height(corner(t, 0))) <= thickness && std::abs(plane.height(corner(t, 1))) <= thickness &&
               std::abs(plane.height(corner(t, 2))) <= thickness;
    };
    Region region{seed};
    include(seed);
    for (std::size_t k = 0; k < region.size(); ++k)
        for (std::size_t side = 0; side < 3; ++side) {
            const int other = neighbour(region[k], side);
            if (other < 0 || !fits(static_cast<std::size_t>(other))) continue;
            include(static_cast<std::size_t>(other));
            region.push_back(static_cast<std::size_t>(other));
        }
    return region;
}

std::vector<FlatFace> CoplanarRegions::with_holes(const Region& region) const {
    const std::set<std::size_t> members(region.begin(), region.end());
    std::map<int, int> next_of;
    for (const std::size_t t : region)
        for (std::size_t side = 0; side < 3; ++side) {
            const int other = neighbour(t, side);
            if (other >= 0 && members.count(static_cast<std::size_t>(other)) > 0) continue;
            const auto& corner = shell_.triangles[t].corner;
            if (!next_of.emplace(corner[side], corner[(side + 1) % 3]).second) return {};
        }
    if (next_of.size() > most_corners) return {};
    const Vec3 front = areas_[region[0]];
    std::vector<int> outline;
    std::vector<std::vector<int>> holes;
    for (std::vector<int>& loop : chained(next_of)) {
        const bool outer = glm::dot(vector_area(polygon_of(shell_.vertices, loop)), front) > 0.0;
        if (outer && !outline.empty()) return {};
        (outer ? outline : holes.emplace_back()) = std::move(loop);
    }
    if (outline.empty()) return {};
    FlatFace face = described(region, std::move(outline));
    face.holes = std::move(holes);
    if (!is_sound_face(shell_.vertices, face)) return {};
    return {std::move(face)};
}

std::vector<FlatFace> CoplanarRegions::without_holes(const Region& region) const {
    std::vector<FlatFace> faces;
    std::set<std::size_t> left(region.begin(), region.end());
    for (const std::size_t seed : region) {
        if (left.erase(seed) == 0) continue;
        GrowingLoop loop(shell_.triangles[seed]);
        std::vector<std::size_t> joined{seed};
        for (std::size_t k = 0; k < joined.size(); ++k)
            for (std::size_t side = 0; side < 3 && loop.size() < most_corners; ++side) {
                const int other = neighbour(joined[k], side);
                const auto number = static_cast<std::size_t>(other);
                if (other < 0 || left.count(number) == 0 || !loop.add(shell_.triangles[number])) continue;
                left.erase(number);
                joined.push_back(number);
            }
        FlatFace face = described(joined, loop.corners());
        if (is_sound_face(shell_.vertices, face)) {
            faces.push_back(std::move(face));
        } else {
            std::vector<FlatFace> single = one_by_one(joined);
            faces.insert(faces.end(), single.begin(), single.end());
        }
    }
    return faces;
}

FlatFace CoplanarRegions::described(const std::vector<std::size_t>& triangles, std::vector<int> loop) const {
    FlatFace face{std::move(loop), {}, 0, 0.0};
    std::map<int, double> shares;
    for (const std::size_t t : triangles) {
        shares[shell_.triangles[t].label] += glm::length(areas_[t]);
        face.area += glm::length(areas_[t]);
    }
    double most = -1.0;
    for (const auto& [label, area] : shares) {
        if (area <= most) continue;
        most = area;
        face.label = label;
    }
    return face;
}

std::vector<FlatFace> CoplanarRegions::one_by_one(const std::vector<std::size_t>& triangles) const {
    std::vector<FlatFace> faces;
    for (const std::size_t t : triangles) {
        const auto& corner = shell_.triangles[t].corner;
        faces.push_back(described({t}, {corner.begin(), corner.end()}));
    }
    return faces;
}

}  // namespace hanei
