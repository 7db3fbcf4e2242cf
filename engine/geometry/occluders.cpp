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

/// A sight line nearer to a body than this many times that distance touches it.
constexpr double touching = 2.0;

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

/// True when the open sight line from + t along (0 < t < 1) runs deeper than `depth` through a solid;
/// below zero, through the solid grown by as much.
bool solid_blocks(const BodyShape& shape, const Vec3& from, const Vec3& along, double depth) {
    double enters = 0.0, leaves = 1.0;
    for (const BodyFace& face : shape.faces) {
        const double start = face.height(from) + depth;
        const double change = glm::dot(along, face.normal);
        if (start >= 0.0 && start + change >= 0.0) return false;
        if (change < 0.0) enters = std::max(enters, -start / change);
        if (change > 0.0) leaves = std::min(leaves, -start / change);
    }
    return enters < leaves;
}

/// The same for a sheet, `depth` measured from its edges; the line must end `same_place` off its plane.
bool sheet_blocks(const BodyShape& shape, const Vec3& from, const Vec3& along, double depth, double same_place) {
    const BodyFace& face = shape.faces[0];
    const double start = face.height(from);
    const double end = start + glm::dot(along, face.normal);
    const bool through = (start > same_place && end < -same_place) || (start < -same_place && end > same_place);
    if (!through) return false;
    const Vec3 crossing = from + (start / (start - end)) * along;
    return std::ranges::all_of(shape.edges, [&](const BodyEdge& edge) {
        const Vec3 run = edge.to - edge.from;
        const double inward = glm::dot(glm::cross(face.normal, run), crossing - edge.from);
        return inward > depth * glm::length(run);
    });
}

bool body_blocks(const BodyShape& shape, const Vec3& from, const Vec3& along, double depth, double same_place) {
    if (shape.faces.empty()) return false;
    return shape.flat ? sheet_blocks(shape, from, along, depth, same_place) : solid_blocks(shape, from, along, depth);
}

/// Across the face or edge along which the sight line touches the body; zero when it only meets a corner.
Vec3 across_contact(const BodyShape& shape, const Vec3& from, const Vec3& along, double same_place) {
    for (const BodyFace& face : shape.faces) {
        const double start = face.height(from), end = start + glm::dot(along, face.normal);
        if (std::max(std::abs(start), std::abs(end)) <= touching * same_place) return face.normal;
    }
    if (!shape.flat) return Vec3{0.0};
    const BodyFace& face = shape.faces[0];
    const Vec3 crossing = from - face.height(from) / glm::dot(along, face.normal) * along;
    for (const BodyEdge& edge : shape.edges) {
        const Vec3 run = edge.to - edge.from;
        const double inward = glm::dot(glm::cross(face.normal, run), crossing - edge.from);
        if (inward <= touching * same_place * glm::length(run)) return glm::cross(along, run);
    }
    return Vec3{0.0};
}

/// Corners of a box along its edges: of a flat one the four of a rectangle, of a thin one two.
std::span<const Vec3> corners_of(const Box& box, std::array<Vec3, 8>& corners) {
    corners[0] = box.low;
    std::size_t count = 1;
    for (int axis = 0; axis < 3; ++axis) {
        if (box.low[axis] == box.high[axis]) continue;
        for (std::size_t k = 0; k < count; ++k) {  // back the way, along the other side
            corners[count + k] = corners[count - 1 - k];
            corners[count + k][axis] = box.high[axis];
        }
        count *= 2;
    }
    return {corners.data(), count};
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
    enclose_pyramid(eye, points, touching * same_place_, pyramid);
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
    enclose_pyramid(eye, points, touching * same_place_, pyramid);
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
    std::array<Vec3, 8> room;
    const std::span<const Vec3> corners = corners_of(eyes, room);
    in_shaft(corners, points, -touching * same_place_, found);  // bodies that only touch it count, as for one eye
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
    const Vec3 along = to - from;
    thread_local std::vector<BodyIndex> touched;
    touched.clear();
    for (const BodyIndex body : candidates) {
        if (!body_blocks(shapes_[body], from, along, -touching * same_place_, same_place_)) continue;
        if (body_blocks(shapes_[body], from, along, same_place_, same_place_)) return true;
        touched.push_back(body);
    }
    return touched.size() > 1 && closes_contact(touched, from, to);
}

/// A sight line that touches bodies runs in the contact between them when it is blocked to whichever
/// side it is moved. Its ends are left out: there it may stand on a body that it only leaves.
bool OccluderSet::closes_contact(std::span<const BodyIndex> touched, const Vec3& from, const Vec3& to) const {
    const Vec3 along = to - from;
    Vec3 across{0.0};
    for (const BodyIndex body : touched) {
        const Vec3 normal = across_contact(shapes_[body], from, along, same_place_);
        across = glm::cross(along, glm::cross(normal, along));
        if (glm::length(across) > 0.0) break;
    }
    if (!(glm::length(across) > 0.0)) return false;
    across = glm::normalize(across);
    const Vec3 beside = glm::normalize(glm::cross(across, along));
    // Aslant, so that where four bodies meet at an edge every move ends in one of them.
    const double far_across = 0.8 * 8.0 * same_place_, far_beside = 0.6 * 8.0 * same_place_;
    const double end = std::min(0.25, 64.0 * same_place_ / glm::length(along));
    const Vec3 inner = (1.0 - 2.0 * end) * along;
    for (const double u : {-far_across, far_across}) {
        for (const double v : {-far_beside, far_beside}) {
            const Vec3 moved = from + end * along + u * across + v * beside;
            const bool blocked = std::ranges::any_of(touched, [&](BodyIndex body) {
                return body_blocks(shapes_[body], moved, inner, same_place_, same_place_);
            });
            if (!blocked) return false;
        }
    }
    return true;
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
