#include "engine/direct/facing_parts.h"

#include "engine/base/tolerance.h"

#include <algorithm>

namespace hanei {

namespace {

double greatest_height(const Plane& plane, std::span<const Vec3> points) {
    double greatest = plane.height(points[0]);
    for (const Vec3& point : points) greatest = std::max(greatest, plane.height(point));
    return greatest;
}

double least_height(const Plane& plane, std::span<const Vec3> points) {
    return -greatest_height({plane.point, -plane.normal}, points);
}

/// The part of a polygon, line or point in front of a plane; the whole when nothing is behind.
Polygon front_part(const Polygon& whole, const Plane& plane, double thickness) {
    if (least_height(plane, whole) >= -thickness) return whole;
    if (whole.size() != 2) return clipped(whole, plane, thickness);
    const double start = plane.height(whole[0]), end = plane.height(whole[1]);
    const Vec3 crossing = whole[0] + (start / (start - end)) * (whole[1] - whole[0]);
    return start > 0.0 ? Polygon{whole[0], crossing} : Polygon{crossing, whole[1]};
}

}  // namespace

std::optional<FacingParts> facing_parts(const ReceivingPolygon& patch, const LuminousPiece& piece) {
    const Plane horizon{patch.outline[0], patch.normal};
    const double reach =
        glm::length(piece.corners[0] - patch.outline[0]) + diameter(piece.corners) + diameter(patch.outline);
    const double touching = tolerance::touching * reach;
    // A patch in the opening's own plane and turned to it lies in the light itself: no case of `away`.
    const bool may_coincide = glm::dot(piece.front, patch.normal) < -0.9;
    if (greatest_height(horizon, piece.corners) <= (may_coincide ? -touching : touching)) return std::nullopt;
    FacingParts facing{{patch.outline.begin(), patch.outline.end()}, front_part(piece.corners, horizon, touching)};
    if (piece.front != Vec3{0.0}) {
        Plane front{piece.corners[0], piece.front};
        for (const Vec3& corner : piece.corners) {
            if (front.height(corner) < 0.0) front.point = corner;
        }
        if (greatest_height(front, facing.patch) <= (may_coincide ? -touching : touching)) return std::nullopt;
        facing.patch = front_part(facing.patch, front, touching);
    }
    // Cut to nothing by rounding: what is left is the border of both. The uncut are a safe superset.
    if (facing.patch.empty()) facing.patch.assign(patch.outline.begin(), patch.outline.end());
    if (facing.opening.empty()) facing.opening = piece.corners;
    return facing;
}

}  // namespace hanei
