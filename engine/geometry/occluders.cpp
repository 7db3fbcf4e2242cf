#include "engine/geometry/occluders.h"

#include "engine/base/tolerance.h"
#include "engine/geometry/enclosure.h"
#include "engine/geometry/hidden_region.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>

namespace hanei {

namespace {

/// A body that hides all by this many times the distance under which places are one hides it in every
/// later test as well, whatever that rounds.
constexpr double clearly = 4.0;

/// Asking more bodies than this one by one takes longer than going down the tree.
constexpr std::size_t most_in_a_row = 64;

double rounding_of_places(const std::vector<ConvexBody>& bodies) {
    Box all;
    double farthest = 0.0;
    bool first = true;
    for (const ConvexBody& body : bodies) {
        for (const Vec3& vertex : body.vertices) {
            if (first) all = {vertex, vertex};
            first = false;
            all.include(vertex);
            farthest = std::max({farthest, std::abs(vertex.x), std::abs(vertex.y), std::abs(vertex.z)});
        }
    }
    return tolerance::same_place * glm::length(all.high - all.low) +
           16.0 * std::numeric_limits<double>::epsilon() * farthest;
}

/// True when the open sight line from + t along (0 < t < 1) runs deeper than `depth` through a solid.
bool solid_blocks(const BodyShape& shape, const Vec3& from, const Vec3& along, double depth) {
    double enters = 0.0, leaves = 1.0;
    for (const BodyFace& face : shape.faces) {
        const double start = face.height(from);
        const double change = glm::dot(along, face.normal);
        if (start >= -depth && start + change >= -depth) return false;
        if (change < 0.0) enters = std::max(enters, -start / change);
        if (change > 0.0) leaves = std::min(leaves, -start / change);
    }
    if (!(enters < leaves) || shape.faces.empty()) return false;
    const Vec3 middle = from + (0.5 * (enters + leaves)) * along;
    return std::ranges::all_of(shape.faces, [&](const BodyFace& face) { return face.height(middle) < -depth; });
}

bool flat_blocks(const BodyShape& shape, const Vec3& from, const Vec3& along, double depth) {
    const BodyFace& face = shape.faces[0];
    const double start = face.height(from);
    const double end = start + glm::dot(along, face.normal);
    const bool through = (start > depth && end < -depth) || (start < -depth && end > depth);
    if (!through) return false;
    const Vec3 crossing = from + (start / (start - end)) * along;
    return std::ranges::all_of(shape.edges, [&](const BodyEdge& edge) {
        const Vec3 run = edge.to - edge.from;
        const double inward = glm::dot(glm::cross(face.normal, run), crossing - edge.from);
        return inward > depth * glm::length(run);
    });
}

bool body_blocks(const BodyShape& shape, const Vec3& from, const Vec3& along, double depth) {
    if (shape.faces.empty()) return false;
    return shape.flat ? flat_blocks(shape, from, along, depth) : solid_blocks(shape, from, along, depth);
}

/// The body that hid everything when this thread last looked from somewhere at a polygon that begins
/// here: a neighbour's view likely ends in it too. A guess to try first; no answer depends on it.
BodyIndex& likely_umbra(const OccluderSet& set, const Vec3& first_corner) {
    constexpr std::size_t views = 256;
    thread_local std::array<BodyIndex, views> last{};
    std::uint64_t key = std::bit_cast<std::uintptr_t>(&set);
    for (const double coordinate : {first_corner.x, first_corner.y, first_corner.z}) {
        key = (key ^ std::bit_cast<std::uint64_t>(coordinate)) * 0x9E3779B97F4A7C15U;
    }
    return last[key >> 56U];
}

}  // namespace

OccluderSet::OccluderSet(std::vector<ConvexBody> bodies) : bodies_(std::move(bodies)) {
    same_place_ = rounding_of_places(bodies_);
    shapes_.reserve(bodies_.size());
    std::vector<Box> boxes;
    boxes.reserve(bodies_.size());
    for (const ConvexBody& body : bodies_) boxes.push_back(shapes_.emplace_back(body, same_place_).box);
    tree_ = BodyTree(boxes);
}

bool OccluderSet::hides(BodyIndex body, const Vec3& eye, std::span<const Vec3> points, std::uint32_t own) const {
    if (own != 0 && bodies_[body].owner == own) return false;
    return hides_all(shapes_[body], eye, points, clearly * same_place_);
}

void OccluderSet::between(const Vec3& eye, std::span<const Vec3> points, std::vector<BodyIndex>& found,
                          std::uint32_t own) const {
    if (points.empty() || bodies_.empty()) return;
    BodyIndex& likely = likely_umbra(*this, points[0]);
    if (likely < bodies_.size() && hides(likely, eye, points, own)) return found.push_back(likely);
    Enclosure pyramid;
    enclose_pyramid(eye, points, same_place_, pyramid);
    const auto start = static_cast<std::ptrdiff_t>(found.size());
    tree_.visit(pyramid, [&](BodyIndex body) {
        if (own != 0 && bodies_[body].owner == own) return true;
        const bool umbra = hides_all(shapes_[body], eye, points, clearly * same_place_);
        if (umbra) found.resize(static_cast<std::size_t>(start)), likely = body;
        found.push_back(body);
        return !umbra;
    });
    std::sort(found.begin() + start, found.end());
}

void OccluderSet::between(const Vec3& eye, std::span<const Vec3> points, std::span<const BodyIndex> among,
                          std::vector<BodyIndex>& found, std::uint32_t own) const {
    if (points.empty() || among.empty()) return;
    if (among.size() > most_in_a_row) return between(eye, points, found, own);
    BodyIndex& likely = likely_umbra(*this, points[0]);
    if (likely < bodies_.size() && hides(likely, eye, points, own)) return found.push_back(likely);
    Enclosure pyramid;
    enclose_pyramid(eye, points, same_place_, pyramid);
    const std::size_t start = found.size();
    for (const BodyIndex body : among) {
        if (!pyramid.may_reach(shapes_[body].box)) continue;
        if (own != 0 && bodies_[body].owner == own) continue;
        if (hides_all(shapes_[body], eye, points, clearly * same_place_)) {
            likely = body;
            found.resize(start);
            return found.push_back(body);
        }
        found.push_back(body);
    }
}

void OccluderSet::between(const Box& eyes, std::span<const Vec3> points, std::vector<BodyIndex>& found) const {
    if (points.empty() || bodies_.empty()) return;
    const Vec3 &low = eyes.low, &high = eyes.high;
    const std::array<Vec3, 8> corners = {{low,
                                          {high.x, low.y, low.z},
                                          {high.x, high.y, low.z},
                                          {low.x, high.y, low.z},
                                          {low.x, high.y, high.z},
                                          high,
                                          {high.x, low.y, high.z},
                                          {low.x, low.y, high.z}}};
    in_shaft(corners, points, -same_place_, found);  // bodies that only touch it count, as for one eye
}

void OccluderSet::between(std::span<const Vec3> from, std::span<const Vec3> to, std::vector<BodyIndex>& found) const {
    if (!from.empty() && !to.empty() && !bodies_.empty()) in_shaft(from, to, same_place_, found);
}

void OccluderSet::in_shaft(std::span<const Vec3> from, std::span<const Vec3> to, double touching,
                           std::vector<BodyIndex>& found) const {
    Enclosure shaft;
    enclose_shaft(from, to, touching, shaft);
    const auto start = static_cast<std::ptrdiff_t>(found.size());
    tree_.visit(shaft, [&](BodyIndex body) {
        if (shaft.may_reach(shapes_[body].box)) found.push_back(body);
        return true;
    });
    std::sort(found.begin() + start, found.end());
}

bool OccluderSet::blocks(const Vec3& from, const Vec3& to) const {
    thread_local std::vector<BodyIndex> candidates;
    candidates.clear();
    between(from, std::span(&to, 1), candidates);
    return blocks(from, to, candidates);
}

bool OccluderSet::blocks(const Vec3& from, const Vec3& to, std::span<const BodyIndex> candidates) const {
    return std::ranges::any_of(
        candidates, [&](BodyIndex body) { return body_blocks(shapes_[body], from, to - from, same_place_); });
}

int OccluderSet::containing(const Vec3& place) const {
    int first = -1;
    Enclosure here;
    here.bounds = {place, place};
    tree_.visit(here, [&](BodyIndex body) {
        const BodyShape& shape = shapes_[body];
        if (shape.flat || shape.faces.empty()) return true;
        const bool inside =
            std::ranges::all_of(shape.faces, [&](const BodyFace& face) { return face.height(place) < -same_place_; });
        if (inside && (first < 0 || static_cast<int>(body) < first)) first = static_cast<int>(body);
        return true;
    });
    return first;
}

}  // namespace hanei
