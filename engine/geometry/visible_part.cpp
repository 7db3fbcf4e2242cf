#include "engine/geometry/visible_part.h"

#include "engine/geometry/configuration_factor.h"
#include "engine/geometry/contour.h"
#include "engine/geometry/polygon.h"
#include "engine/geometry/visible_pieces.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace hanei {

namespace {

/// Memory of one thread, used again for every receiver.
struct Scratch {
    std::vector<Vec3> seen;
    std::vector<HalfSpace> planes;
    VisiblePieces pieces;
};

Scratch& scratch() {
    thread_local Scratch memory;
    return memory;
}

void see_from(const Vec3& eye, std::span<const Vec3> polygon, std::vector<Vec3>& seen) {
    seen.resize(polygon.size());
    for (std::size_t k = 0; k < polygon.size(); ++k) seen[k] = polygon[k] - eye;
}

/// False when nothing of the polygon is left.
bool subtract_bodies(Scratch& memory, const Vec3& eye, const Vec3& beside, const OccluderSet& occluders,
                     std::span<const BodyIndex> candidates) {
    for (const BodyIndex body : candidates) {
        const Hides hides = hidden_region(occluders.shape(body), eye, beside, occluders.same_place(), memory.planes);
        if (hides == Hides::everything) return false;
        if (hides == Hides::nothing) continue;
        memory.pieces.subtract(memory.planes);
        if (memory.pieces.empty()) return false;
    }
    return true;
}

/// Share of one piece by the receiver at the origin.
double piece_factor(std::span<const Vec3> piece, const Vec3& normal) {
    thread_local std::vector<Vec3> offsets;
    see_from(piece[0], piece, offsets);
    return contour_factor({piece[0], offsets}, normal);
}

}  // namespace

std::vector<Polygon> visible_part(const Polygon& polygon, const Vec3& eye, const OccluderSet& occluders,
                                  std::span<const BodyIndex> candidates) {
    Scratch& memory = scratch();
    see_from(eye, polygon, memory.seen);
    memory.pieces.start(memory.seen);
    if (!subtract_bodies(memory, eye, Vec3{0.0}, occluders, candidates)) return {};
    if (memory.pieces.untouched()) return {polygon};
    std::vector<Polygon> visible(memory.pieces.size());
    for (std::size_t k = 0; k < visible.size(); ++k) {
        for (const Vec3& point : memory.pieces[k]) visible[k].push_back(eye + point);
    }
    return visible;
}

std::vector<std::pair<double, double>> visible_intervals(const Vec3& from, const Vec3& to, const Vec3& eye,
                                                         const OccluderSet& occluders,
                                                         std::span<const BodyIndex> candidates) {
    Scratch& memory = scratch();
    std::vector<std::pair<double, double>> visible{{0.0, 1.0}};
    const Vec3 start = from - eye, end = to - eye;
    for (const BodyIndex body : candidates) {
        const Hides hides = hidden_region(occluders.shape(body), eye, Vec3{0.0}, occluders.same_place(), memory.planes);
        if (hides == Hides::everything) return {};
        if (hides == Hides::nothing) continue;
        double enters = 0.0, leaves = 1.0;
        for (const HalfSpace& plane : memory.planes) {
            const double at_start = glm::dot(plane.outward, start) - plane.reach;
            const double at_end = glm::dot(plane.outward, end) - plane.reach;
            // Along a silhouette plane the line is touched, not hidden.
            const double slack = occluders.same_place() *
                                 (std::abs(plane.outward.x) + std::abs(plane.outward.y) + std::abs(plane.outward.z));
            if (at_start >= -slack && at_end >= -slack) leaves = -1.0;
            if (at_start > 0.0 && at_end < 0.0) enters = std::max(enters, at_start / (at_start - at_end));
            if (at_start < 0.0 && at_end > 0.0) leaves = std::min(leaves, at_start / (at_start - at_end));
        }
        if (!(enters < leaves)) continue;
        std::vector<std::pair<double, double>> left;
        for (const auto& [low, high] : visible) {
            if (low < std::min(high, enters)) left.emplace_back(low, std::min(high, enters));
            if (std::max(low, leaves) < high) left.emplace_back(std::max(low, leaves), high);
        }
        visible = std::move(left);
    }
    return visible;
}

double visible_configuration_factor(const Polygon& polygon, const Receiver& receiver, const OccluderSet& occluders,
                                    std::span<const BodyIndex> candidates) {
    if (candidates.empty()) return configuration_factor(polygon, receiver);
    const Vec3 front = unit_normal(polygon);
    if (front == Vec3{0.0}) return 0.0;
    Scratch& memory = scratch();
    see_from(receiver.position, polygon, memory.seen);
    double farthest = 0.0;
    for (const Vec3& point : memory.seen) farthest = std::max(farthest, glm::length(point));
    const double touching = touching_distance(receiver, farthest);
    const double height = -glm::dot(memory.seen[0], front);
    if (height < -touching) return 0.0;

    memory.pieces.start(memory.seen);
    memory.planes.assign(1, HalfSpace{receiver.normal, 0.0, 0.0});  // below the horizon
    memory.pieces.subtract(memory.planes);
    if (memory.pieces.empty()) return 0.0;
    const bool above_horizon = memory.pieces.untouched();
    if (!subtract_bodies(memory, receiver.position, receiver.inward, occluders, candidates)) return 0.0;
    if (above_horizon && memory.pieces.untouched()) return configuration_factor(polygon, receiver);

    double sum = 0.0;
    const Receiver at_origin{Vec3{0.0}, receiver.normal, receiver.inward};
    for (std::size_t k = 0; k < memory.pieces.size(); ++k) {
        sum += height > touching ? piece_factor(memory.pieces[k], receiver.normal)
                                 : configuration_factor(memory.pieces[k], at_origin);
    }
    return std::clamp(sum, 0.0, 1.0);
}

}  // namespace hanei
