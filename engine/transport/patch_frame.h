/// A flat convex polygon described by the moments of its area: where its middle is, which way it
/// extends, and how far.
#pragma once

#include "engine/base/vector.h"

#include <array>
#include <span>

namespace hanei {

/// The principal axes of a polygon's area. Over the polygon the coordinates xi and eta have the mean
/// 0, the variance 1 and no correlation, so that the mean of any bilinear function of them is the mean
/// of its four values at (+-1, +-1). Of a rectangle these are the points of Gauss's rule of 2 x 2.
///
/// Holds     the four points lie in every convex polygon: it contains the ellipse of sqrt(2) standard
///           deviations (Kannan, Lovasz and Simonovits 1995).
struct PatchFrame {
    Vec3 centre{0.0};
    Vec3 along{0.0}, across{0.0};  ///< one standard deviation of the area each way, m

    Vec3 place(double xi, double eta) const { return centre + xi * along + eta * across; }
    Vec2 coordinates(const Vec3& place) const;

    /// Node k of four: bit 0 set where xi is +1, bit 1 where eta is.
    Vec3 node(unsigned k) const { return place(k & 1U ? 1.0 : -1.0, k & 2U ? 1.0 : -1.0); }
};

/// Needs     a convex polygon with area and its unit normal; `wished`, the direction that `along` is to
///           be nearest to of the two axes (the grid of the face).
/// Returns   axes along an edge where the polygon extends equally every way.
PatchFrame frame_of(std::span<const Vec3> polygon, const Vec3& normal, const Vec3& wished);

/// The four parts of a convex polygon around its frame's axes, part k around node k of the frame.
/// Returns   none empty, as the nodes lie in them; convex, wound as the polygon.
std::array<Polygon, 4> quarters_of(const Polygon& polygon, const PatchFrame& frame);

/// Means over a part of a polygon in the coordinates of its frame.
struct FrameMeans {
    double area = 0.0;
    double xi = 0.0, eta = 0.0, product = 0.0;  ///< of xi, eta and xi x eta
};
FrameMeans means_over(std::span<const Vec3> part, const PatchFrame& frame);

}  // namespace hanei
