/// The share of the hemisphere over a point that a polygon covers, weighted by the cosine: its
/// form factor from a differential area (Lambert's contour formula).
#pragma once

#include "engine/base/vector.h"

#include <span>

namespace hanei {

/// Where light arrives: a point and the unit normal of the surface there.
struct Receiver {
    Vec3 position{0.0};
    Vec3 normal{0.0, 0.0, 1.0};
    /// Direction from the point into its own face, for points on an edge or corner of it: the value
    /// is the limit from there. Zero for a free point.
    Vec3 inward{0.0};
    bool operator==(const Receiver&) const = default;
};

/// Form factor from the receiver to a polygon of any simple shape, unobstructed. With M the
/// luminous exitance of a diffuse polygon, M times this is the illuminance it gives.
///
///     F = 1/(2 pi) sum over edges  gamma_k  n . (b_k x a_k) / |b_k x a_k|
///
/// with a_k, b_k the ends of edge k seen from the point and gamma_k the angle between them.
///
/// One-sided: the front of the polygon (counter-clockwise side) shines. Clipped at the receiver's
/// horizon. Holes are given as clockwise loops and add (negatively).
///
/// Returns   0 to 1, never NaN; 0 when the polygon faces away, has no area or lies in the
///           receiver's plane; 1 where the point lies in the polygon and they face each other.
/// Holds     1e-15 of the form factor in the median and 1e-12 at worst where rounding the coordinates
///           does not move it by more than 1e-15; 1e-14 of one elsewhere (5e-14 for polygons 1000 times as
///           wide as they are far), but near an edge 1e-16 over the share of the distance that is left.
/// Weak when the point lies on an edge of the polygon and `inward` is zero.
/// Cost      25 ns an edge for quadrilaterals, 15 for outlines of many corners; no allocation for up to 32;
///           any thread.
double configuration_factor(std::span<const Vec3> polygon, const Receiver& receiver);
double configuration_factor(const Region& region, const Receiver& receiver);

}  // namespace hanei
