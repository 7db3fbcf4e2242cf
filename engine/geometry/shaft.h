/// The convex hull of two sets of points: every sight line between them lies in it.
#pragma once

#include "engine/geometry/body_shape.h"

#include <array>
#include <span>

namespace hanei {

/// Tells boxes that certainly do not reach into the shaft from those that may: separating axes
/// along the coordinates, and across planes through an edge of one polygon and a corner of the other.
///
/// Needs     points in the order of convex polygons for a tight answer; any order is safe.
class Shaft {
public:
    /// Boxes that reach less than `touching` into the shaft count as outside; below zero, boxes that
    /// far outside count as reaching it.
    Shaft(std::span<const Vec3> from, std::span<const Vec3> to, double touching);

    bool may_reach(const Box& box) const;

private:
    struct Axis {
        Vec3 direction, magnitude;
        double low, high;
    };
    void add_axis(const Vec3& direction, std::span<const Vec3> from, std::span<const Vec3> to);
    void add_sides(std::span<const Vec3> edges, std::span<const Vec3> corners);

    Vec3 origin_;
    Box bounds_;
    double touching_;
    std::size_t count_ = 0;
    std::array<Axis, 24> axes_;
};

}  // namespace hanei
