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

using Interval = std::pair<double, double>;

void take_away(std::vector<Interval>& visible, const Interval& hidden) {
    const auto [enters, leaves] = hidden;
    if (!(enters < leaves)) return;
    std::vector<Interval> left;
    for (const auto& [low, high] : visible) {
        if (low < std::min(high, enters)) left.emplace_back(low, std::min(high, enters));
        if (std::max(low, leaves) < high) left.emplace_back(std::max(low, leaves), high);
    }
    visible = std::move(left);
}

struct HiddenInterval {
    Interval interval{0.0, 0.0};
    bool touches = false;  ///< the body ends in the plane of eye and line, and would hide the interval otherwise
    Vec3 across{0.0};      ///< normal of that plane
};

struct Touched {
    BodyIndex number;
    Vec3 across;
};

/// What one body hides of the line from + t (to - from). Along a plane of its skin or silhouette the
/// line is touched, not hidden.
HiddenInterval hidden_interval(const OccluderSet& occluders, BodyIndex body, const Vec3& eye, const Vec3& from,
                               const Vec3& to) {
    std::vector<HalfSpace>& planes = scratch().planes;
    const Hides hides = hidden_region(occluders.shape(body), eye, Vec3{0.0}, occluders.same_place(), planes);
    if (hides == Hides::nothing) return {};
    if (hides == Hides::everything) return {{0.0, 1.0}, false, {}};
    const Vec3 start = from - eye, end = to - eye;
    HiddenInterval hidden{{0.0, 1.0}, false, {}};
    for (const HalfSpace& plane : planes) {
        const double at_start = glm::dot(plane.outward, start) - plane.reach;
        const double at_end = glm::dot(plane.outward, end) - plane.reach;
        const double slack = occluders.same_place() *
                             (std::abs(plane.outward.x) + std::abs(plane.outward.y) + std::abs(plane.outward.z));
        if (at_start >= -slack && at_end >= -slack) {
            const bool before_body = plane.reach != 0.0;  // the line lies on a face turned to the eye
            if (before_body || at_start > slack || at_end > slack) return {};
            hidden.touches = true;
            hidden.across = plane.outward;
            continue;
        }
        if (at_start > 0.0 && at_end < 0.0) {
            hidden.interval.first = std::max(hidden.interval.first, at_start / (at_start - at_end));
        }
        if (at_start < 0.0 && at_end > 0.0) {
            hidden.interval.second = std::min(hidden.interval.second, at_start / (at_start - at_end));
        }
    }
    return hidden.interval.first < hidden.interval.second ? hidden : HiddenInterval{};
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

std::vector<Interval> visible_intervals(const Vec3& from, const Vec3& to, const Vec3& eye, const OccluderSet& occluders,
                                        std::span<const BodyIndex> candidates) {
    std::vector<Interval> visible{{0.0, 1.0}};
    std::vector<Touched> touched;
    for (const BodyIndex body : candidates) {
        const HiddenInterval hidden = hidden_interval(occluders, body, eye, from, to);
        if (hidden.touches) {
            touched.push_back({body, hidden.across});
        } else {
            take_away(visible, hidden.interval);
        }
    }
    if (touched.size() < 2 || touched[0].across == Vec3{0.0}) return visible;
    // A line in the contact of bodies is hidden where it is hidden to either side of it.
    const Vec3 aside = 8.0 * occluders.same_place() * glm::normalize(touched[0].across);
    const auto hidden_beside = [&](const Vec3& moved) {
        std::vector<Interval> hidden;
        for (const Touched& body : touched) {
            hidden.push_back(hidden_interval(occluders, body.number, eye + moved, from + moved, to + moved).interval);
        }
        return hidden;
    };
    const std::vector<Interval> right = hidden_beside(-aside);
    for (const auto& [low, high] : hidden_beside(aside)) {
        for (const Interval& other : right)
            take_away(visible, {std::max(low, other.first), std::min(high, other.second)});
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
