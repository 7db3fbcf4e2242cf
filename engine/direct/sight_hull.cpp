#include "engine/direct/sight_hull.h"

#include <algorithm>
#include <cmath>

namespace hanei {

namespace {

std::size_t edge_count(std::span<const Vec3> points) { return points.size() < 3 ? points.size() - 1 : points.size(); }

}  // namespace

double SightHull::reach(const Vec3& direction) const {
    double farthest = 0.0;  // the first point's own
    for (const std::span<const Vec3> points : {from_, to_}) {
        for (const Vec3& point : points) farthest = std::max(farthest, glm::dot(direction, point - from_[0]));
    }
    return farthest;
}

bool SightHull::is_before_a_face(const BodyShape& shape, double touching) const {
    const auto all = [&](const BodyFace& face, double front) {
        const auto before = [&](const Vec3& point) { return front * face.height(point) >= -touching; };
        return std::ranges::all_of(from_, before) && std::ranges::all_of(to_, before);
    };
    return std::ranges::any_of(shape.faces, [&](const BodyFace& face) { return all(face, 1.0); }) ||
           (shape.flat && all(shape.faces[0], -1.0));
}

bool SightHull::is_beyond(const Axis& axis, std::span<const Vec3> vertices, double touching) const {
    return std::ranges::all_of(vertices, [&](const Vec3& vertex) {
        return glm::dot(axis.direction, vertex - from_[0]) >= axis.reach - touching;
    });
}

void SightHull::add_both_ways(const Vec3& direction) {
    const double length = glm::length(direction);
    if (!(length > 0.0)) return;
    for (const double way : {1.0, -1.0}) sides_.push_back({way / length * direction, 0.0});
    for (auto axis = sides_.end() - 2; axis != sides_.end(); ++axis) axis->reach = reach(axis->direction);
}

/// Planes through an edge of the one and a corner of the other, with everything on one side.
void SightHull::add_sides(std::span<const Vec3> edges, std::span<const Vec3> corners) {
    for (std::size_t k = 0; k < edge_count(edges); ++k) {
        const Vec3 edge = edges[(k + 1) % edges.size()] - edges[k];
        if (edge == Vec3{0.0}) continue;
        edges_.push_back(edge);
        for (const Vec3& corner : corners) {
            const Vec3 across = glm::cross(edge, corner - edges[k]);
            double low = 0.0, high = 0.0;
            for (const std::span<const Vec3> points : {from_, to_}) {
                for (const Vec3& point : points) {
                    const double height = glm::dot(across, point - edges[k]);
                    low = std::min(low, height);
                    high = std::max(high, height);
                }
            }
            if (low < -1e-9 * high && high > -1e-9 * low) continue;
            edges_.push_back(corner - edges[k]);
            edges_.push_back(corner - edges[(k + 1) % edges.size()]);
            const double length = glm::length(across);
            if (!(length > 0.0)) continue;
            const Vec3 outward = (high <= -low ? 1.0 : -1.0) / length * across;
            sides_.push_back({outward, reach(outward)});
        }
    }
}

void SightHull::find_sides() {
    sides_known_ = true;
    add_sides(from_, to_);
    add_sides(to_, from_);
    if (from_.size() > 2) add_both_ways(glm::cross(from_[1] - from_[0], from_[2] - from_[0]));
    if (to_.size() > 2) add_both_ways(glm::cross(to_[1] - to_[0], to_[2] - to_[0]));
    if (edges_.empty()) edges_.push_back(to_[0] - from_[0]);  // from a point to a point
}

bool SightHull::edges_separate(const BodyShape& shape, std::span<const Vec3> vertices, double touching) {
    if (!sides_known_) find_sides();
    std::vector<Vec3> runs;  // every direction of the body's edges once
    for (const BodyEdge& edge : shape.edges) {
        const Vec3 run = glm::normalize(edge.to - edge.from);
        const bool known =
            std::ranges::any_of(runs, [&](const Vec3& other) { return std::abs(glm::dot(run, other)) > 1.0 - 1e-12; });
        if (!known) runs.push_back(run);
    }
    for (const Vec3& run : runs) {
        for (const Vec3& edge : edges_) {
            const Vec3 across = glm::cross(run, edge);
            const double length = glm::length(across);
            if (!(length > 1e-9 * glm::length(edge))) continue;  // alike: a face's axis does it
            for (const double way : {1.0, -1.0}) {
                const Vec3 direction = way / length * across;
                if (is_beyond({direction, reach(direction)}, vertices, touching)) return true;
            }
        }
    }
    return false;
}

bool SightHull::is_soon_clear_of(const BodyShape& shape, std::span<const Vec3> vertices, double touching) {
    if (shape.faces.empty() || is_before_a_face(shape, touching)) return true;
    if (!sides_known_) find_sides();
    return std::ranges::any_of(sides_, [&](const Axis& axis) { return is_beyond(axis, vertices, touching); });
}

}  // namespace hanei
