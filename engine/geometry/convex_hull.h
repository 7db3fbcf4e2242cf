/// The convex hull of points in one plane.
#pragma once

#include "engine/base/vector.h"

#include <span>

namespace hanei {

/// Corners of the hull of points in a plane, counter-clockwise about its unit `normal`, without
/// those on the hull's edges (Andrew's monotone chain). Empty when the points lie on one line.
Polygon convex_hull(std::span<const Vec3> points, const Vec3& normal);

}  // namespace hanei
