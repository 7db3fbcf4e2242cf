/// The part of a polygon or line that is visible from a point past convex bodies, exactly.
///
/// Each body's silhouette seen from the point spans planes through the point; the polygon is cut by
/// these planes in three dimensions, never projected, so bodies at the point's height are no
/// trouble (Nishita and Nakamae 1985, the visible part of a source; silhouette planes: METHOD).
#pragma once

#include "engine/geometry/occluders.h"

#include <span>
#include <utility>
#include <vector>

namespace hanei {

/// Convex pieces of the convex `polygon` visible from `eye` past the candidate bodies. Pieces do
/// not overlap and are wound as the polygon. A body that contains `eye` hides everything.
std::vector<Polygon> visible_part(const Polygon& polygon, const Vec3& eye, const OccluderSet& occluders,
                                  std::span<const BodyIndex> candidates);

/// Visible intervals of the segment from + t (to - from), 0 <= t <= 1, ascending.
std::vector<std::pair<double, double>> visible_intervals(const Vec3& from, const Vec3& to, const Vec3& eye,
                                                         const OccluderSet& occluders,
                                                         std::span<const BodyIndex> candidates);

/// Form factor from the receiver to the visible part of a convex polygon.
double visible_configuration_factor(const Polygon& polygon, const struct Receiver& receiver,
                                    const OccluderSet& occluders, std::span<const BodyIndex> candidates);

}  // namespace hanei
