/// The shadow that a convex body casts, as an intersection of half-spaces: the paper's fourth step.
#pragma once

#include "engine/geometry/occluders.h"
#include "engine/geometry/polygon.h"

#include <span>
#include <vector>

namespace hanei {

/// Half-spaces whose intersection is the set of places from which the body hides some of the source:
/// { b + u (b - q) : b in the body, q in the source, u >= 0 }, the penumbra volume with the umbra in
/// it, which is convex. Its faces are faces of the body that the whole source is before, and planes
/// through an edge of the one and a corner of the other that keep the two apart. From one point of a
/// source, this is the shadow itself; the umbra is what the shadows from all corners share.
///
/// Needs     a source of a convex polygon's corners in order, two ends of a line, or one point;
///           `same_place`, the distance under which a corner is on a plane.
/// Returns   planes with the volume behind them. None when body and source cannot be kept apart:
///           then the shadow is everywhere.
std::vector<Plane> shadow_planes(const BodyShape& shape, std::span<const Vec3> vertices, std::span<const Vec3> source,
                                 double same_place);

}  // namespace hanei
