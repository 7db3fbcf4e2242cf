/// Lambert's contour sum over loops already seen from the receiver: what configuration factors,
/// whole or of visible parts, are made of.
#pragma once

#include "engine/base/vector.h"

#include <span>

namespace hanei {

struct Receiver;

/// Distance under which a receiver lies on a polygon's plane or edge: tolerance::touching of the
/// farthest corner, tolerance::same_place for one known to lie on the edge of its own face, and
/// never less than the rounding of the coordinates.
double touching_distance(const Receiver& receiver, double farthest_corner);

/// A loop of points with the receiver at the origin, kept as one point and offsets from it: edges
/// of a small, far loop then carry no rounding of the distance.
struct SeenLoop {
    Vec3 first{0.0};                ///< receiver to the loop's first point
    std::span<const Vec3> offsets;  ///< from there to every point; offsets[0] is zero

    std::size_t size() const { return offsets.size(); }
    Vec3 point(std::size_t k) const { return first + offsets[k]; }
};

/// Form factor from the origin (unit normal `normal`) to the front of a loop that lies off the
/// origin's place, cut at the horizon.
///
/// Needs     an origin in front of the loop's plane, farther than rounding from it.
/// Returns   negative values for a clockwise loop (a hole).
double contour_factor(const SeenLoop& loop, const Vec3& normal);

/// The same for a loop whose plane contains the origin: the limit as the receiver comes to the
/// origin from `beside` it. Loops that do not touch the origin give 0.
///
/// Needs     `plane` the loop's unit normal; `beside` a unit vector from the origin to the front of
///           the plane; `touching` the distance under which the origin is on an edge.
double contour_limit(const SeenLoop& loop, const Vec3& normal, const Vec3& plane, const Vec3& beside, double touching);

}  // namespace hanei
