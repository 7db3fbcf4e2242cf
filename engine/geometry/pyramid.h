/// The convex hull of an eye and the points it looks at.
#pragma once

#include "engine/geometry/body_shape.h"

#include <array>
#include <span>

namespace hanei {

/// Tells boxes that certainly do not touch the pyramid from those that may: separating axes along
/// the coordinates, the planes through the eye and consecutive points, and the points' own plane.
///
/// Needs     points in the order of a convex polygon for a tight answer; any order is safe.
class Pyramid {
public:
    /// Boxes within `margin` of the pyramid, or up to twice that, count as touching.
    Pyramid(const Vec3& eye, std::span<const Vec3> points, double margin);

    bool may_touch(const Box& box) const;

private:
    struct Axis {
        Vec3 direction, magnitude;  ///< not normalised
        double low, high;           ///< of the pyramid along it, seen from the eye
    };
    void add_axis(const Vec3& direction, std::span<const Vec3> points);

    Vec3 eye_;
    Box bounds_;
    double margin_;
    std::size_t count_ = 0;
    std::array<Axis, 9> axes_;
};

}  // namespace hanei
