/// Form factors between two polygons with nothing in between, by their contours.
#pragma once

#include "engine/base/vector.h"

namespace hanei {

/// Area of `from` times its form factor to `to`:
///
///     A F = 1/(2 pi) sum over pairs of edges of  (u . v) x integral integral ln r ds dt
///
/// The inner integral has a closed form; the outer one is adaptive. Good to about 1e-12 of
/// the area, also for polygons that share an edge.
///
/// Needs     convex polygons, each wholly in front of the other's plane or on it.
double contour_exchange(const Polygon& from, const Polygon& to);

}  // namespace hanei
