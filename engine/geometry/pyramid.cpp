#include "engine/geometry/pyramid.h"

#include <algorithm>
#include <cmath>

namespace hanei {

Pyramid::Pyramid(const Vec3& eye, std::span<const Vec3> points, double margin)
    : eye_(eye), bounds_{eye, eye}, margin_(margin) {
    for (const Vec3& point : points) bounds_.include(point);
    bounds_.low -= Vec3{margin};
    bounds_.high += Vec3{margin};
    if (points.size() == 1) {
        const Vec3 along = points[0] - eye;
        for (int axis = 0; axis < 3; ++axis) {
            Vec3 unit{0.0};
            unit[axis] = 1.0;
            add_axis(glm::cross(along, unit), points);
        }
        return;
    }
    const std::size_t sides = points.size() == 2 ? 1 : std::min(points.size(), axes_.size() - 1);
    for (std::size_t side = 0; side < sides; ++side) {
        const std::size_t k = side * points.size() / sides;
        add_axis(glm::cross(points[k] - eye, points[(k + 1) % points.size()] - eye), points);
    }
    if (points.size() > 2) add_axis(glm::cross(points[1] - points[0], points[2] - points[0]), points);
}

void Pyramid::add_axis(const Vec3& direction, std::span<const Vec3> points) {
    if (direction == Vec3{0.0}) return;
    Axis& axis = axes_[count_++];
    axis = {direction, glm::abs(direction), 0.0, 0.0};
    for (const Vec3& point : points) {
        const double along = glm::dot(axis.direction, point - eye_);
        axis.low = std::min(axis.low, along);
        axis.high = std::max(axis.high, along);
    }
    // A direction is no longer than its components together: at least the margin in metres.
    const double margin = margin_ * (axis.magnitude.x + axis.magnitude.y + axis.magnitude.z);
    axis.low -= margin;
    axis.high += margin;
}

bool Pyramid::may_touch(const Box& box) const {
    if (box.low.x > bounds_.high.x || box.low.y > bounds_.high.y || box.low.z > bounds_.high.z) return false;
    if (box.high.x < bounds_.low.x || box.high.y < bounds_.low.y || box.high.z < bounds_.low.z) return false;
    const Vec3 centre = box.centre() - eye_;
    const Vec3 half = box.half_size();
    for (std::size_t k = 0; k < count_; ++k) {
        const Axis& axis = axes_[k];
        const double at = glm::dot(axis.direction, centre);
        const double reach = glm::dot(axis.magnitude, half);
        if (at - reach > axis.high || at + reach < axis.low) return false;
    }
    return true;
}

}  // namespace hanei
