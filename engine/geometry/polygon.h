/// Planar polygons: area, normal, clipping, cutting into convex pieces.
#pragma once

#include "engine/base/vector.h"

#include <span>
#include <vector>

namespace hanei {

/// Half the sum of the cross products of the edges: normal times area (Newell).
Vec3 vector_area(std::span<const Vec3> polygon);
Vec3 vector_area(const Region& region);

/// Unit normal of the front; zero vector when the polygon has no area (tolerance::no_area).
Vec3 unit_normal(std::span<const Vec3> polygon);
Vec3 centroid(std::span<const Vec3> polygon);               ///< of the area; mean of the points when there is none
double diameter(std::span<const Vec3> points);              ///< diagonal of the axis-aligned bounds
double distance_from_plane(std::span<const Vec3> polygon);  ///< farthest vertex from the mean plane
bool is_convex(std::span<const Vec3> polygon, const Vec3& normal);
double signed_area(std::span<const Vec2> polygon);  ///< positive when it runs counter-clockwise
bool is_simple(std::span<const Vec2> polygon);      ///< no two edges touch but neighbours at their shared point

/// A plane by a point on it and its unit normal.
struct Plane {
    Vec3 point{0.0};
    Vec3 normal{0.0, 0.0, 1.0};
    double height(const Vec3& p) const { return glm::dot(p - point, normal); }
};

/// The part of a convex polygon on the front of a plane; empty when none. Vertices within
/// `thickness` of the plane count as on it.
Polygon clipped(const Polygon& polygon, const Plane& plane, double thickness);

/// `whole` minus `cutter`, both convex and in one plane: convex pieces that do not overlap and
/// together cover what is left, slivers under `thickness` dropped.
/// Also `inside`, when not null: the part of `whole` inside the cutter (may be empty).
std::vector<Polygon> subtracted(const Polygon& whole, const Polygon& cutter, double thickness,
                                Polygon* inside = nullptr);

/// Convex pieces covering a simple region with holes, each wound as the region. Ear clipping over
/// bridged holes, then merged while convex (Hertel and Mehlhorn 1983). Empty without area.
std::vector<Polygon> convex_pieces(const Region& region);

}  // namespace hanei
