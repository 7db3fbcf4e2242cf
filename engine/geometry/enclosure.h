/// Convex regions of space that hold every sight line of a question, as planes they lie behind.
#pragma once

#include "engine/geometry/body_shape.h"

#include <array>
#include <cstddef>
#include <span>

namespace hanei {

/// Tells boxes that certainly do not reach into the region from those that may: a box beyond one of
/// the planes, or off the bounds, does not.
///
/// Holds     a superset of the region, cheap to hold against many boxes (BodyTree four at a time).
struct Enclosure {
    /// The region is where outward . (x - origin) <= reach. Not normalised.
    struct Side {
        Vec3 outward;
        double reach;
    };

    Box bounds;
    Vec3 origin{0.0};
    Vec3 forward{0.0};  ///< away from the eye; zero when no box is nearer than another
    std::size_t count = 0;
    std::array<Side, 48> sides;

    bool may_reach(const Box& box) const;
    std::span<const Side> planes() const { return {sides.data(), count}; }
};

/// The hull of an eye and the points it looks at. Boxes within `margin` of it, or up to twice that,
/// count as reaching it.
///
/// Needs     points in the order of a convex polygon for a tight answer; any order is safe.
void enclose_pyramid(const Vec3& eye, std::span<const Vec3> points, double margin, Enclosure& region);

/// The hull of two sets of points. Boxes that reach less than `touching` into it count as outside;
/// below zero, boxes that far outside count as reaching it.
///
/// Needs     points in the order of convex polygons for a tight answer; any order is safe.
void enclose_shaft(std::span<const Vec3> from, std::span<const Vec3> to, double touching, Enclosure& region);

}  // namespace hanei
