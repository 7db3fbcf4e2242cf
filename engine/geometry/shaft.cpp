#include "engine/geometry/shaft.h"

#include <algorithm>
#include <cmath>

namespace hanei {

Shaft::Shaft(std::span<const Vec3> from, std::span<const Vec3> to, double touching)
    : origin_(from[0]), bounds_{from[0], from[0]}, touching_(touching) {
    for (const Vec3& point : from) bounds_.include(point);
    for (const Vec3& point : to) bounds_.include(point);
    add_sides(from, to);
    add_sides(to, from);
    if (from.size() > 2) add_axis(glm::cross(from[1] - from[0], from[2] - from[0]), from, to);
    if (to.size() > 2) add_axis(glm::cross(to[1] - to[0], to[2] - to[0]), from, to);
}

void Shaft::add_sides(std::span<const Vec3> edges, std::span<const Vec3> corners) {
    if (edges.size() < 2) return;
    const std::size_t sides = std::min<std::size_t>(edges.size(), 8);
    for (std::size_t side = 0; side < sides; ++side) {
        const std::size_t k = side * edges.size() / sides;
        const Vec3 edge = edges[(k + 1) % edges.size()] - edges[k];
        for (const Vec3& corner : corners) {
            const Vec3 across = glm::cross(edge, corner - edges[k]);
            // Only planes with the whole shaft on one side keep anything out.
            double low = 0.0, high = 0.0;
            for (const std::span<const Vec3> points : {edges, corners}) {
                for (const Vec3& point : points) {
                    const double height = glm::dot(across, point - edges[k]);
                    low = std::min(low, height);
                    high = std::max(high, height);
                }
            }
            if (low < -1e-9 * high && high > -1e-9 * low) continue;
            add_axis(across, edges, corners);
        }
    }
}

void Shaft::add_axis(const Vec3& direction, std::span<const Vec3> from, std::span<const Vec3> to) {
    const double length = glm::length(direction);
    if (length == 0.0 || count_ == axes_.size()) return;
    Axis& axis = axes_[count_++];
    axis = {direction / length, glm::abs(direction / length), 0.0, 0.0};
    for (const std::span<const Vec3> points : {from, to}) {
        for (const Vec3& point : points) {
            const double along = glm::dot(axis.direction, point - origin_);
            axis.low = std::min(axis.low, along);
            axis.high = std::max(axis.high, along);
        }
    }
}

bool Shaft::may_reach(const Box& box) const {
    const Vec3 low = box.low + Vec3{touching_}, high = box.high - Vec3{touching_};
    if (glm::any(glm::greaterThan(low, bounds_.high)) || glm::any(glm::lessThan(high, bounds_.low))) return false;
    const Vec3 centre = box.centre() - origin_;
    const Vec3 half = box.half_size();
    for (std::size_t k = 0; k < count_; ++k) {
        const Axis& axis = axes_[k];
        const double at = glm::dot(axis.direction, centre);
        const double reach = glm::dot(axis.magnitude, half) - touching_;
        if (at - reach > axis.high || at + reach < axis.low) return false;
    }
    return true;
}

}  // namespace hanei
