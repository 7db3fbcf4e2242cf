/// Convex pieces of planar regions.
#pragma once

#include "engine/base/vector.h"

#include <vector>

namespace hanei {

/// Convex pieces of a region; the outline itself when it is convex and has no holes.
std::vector<Polygon> pieces_of(const Region& region, const Vec3& normal);

/// The common part of two convex polygons in one plane, the second counter-clockwise about `normal`.
/// Edges of the second within `thickness` of corners of the first cut nothing off.
Polygon common_part(const Polygon& a, const Polygon& b, const Vec3& normal, double thickness);

}  // namespace hanei
