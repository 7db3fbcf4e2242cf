/// How the light of a patch arrives: how much, and from where on the patch.
#pragma once

#include "engine/geometry/configuration_factor.h"
#include "engine/transport/patch_frame.h"

#include <array>

namespace hanei {

/// The form factor from a receiver to a polygon and the middle of its integrand,
///
///     F = integral of K dA,     (xi, eta, product) = integral of K (xi, eta, xi eta) dA / F
///
/// in the coordinates of the polygon's frame.
struct KernelMiddle {
    double factor = 0.0;
    Vec2 middle{0.0};
    double product = 0.0;
};

/// Nearby the middle is a sum over edges as the factor is: arc tangents, logarithms and one integral of a
/// smooth function by Gauss's rule. Far away the kernel at four points.
///
/// Needs     a convex polygon.
/// Returns   the factor of configuration_factor; the middle of the part above the horizon; a receiver in
///           the polygon's plane sees all light where it is itself; zeros where nothing is seen.
/// Holds     the middle to 1e-5 of a deviation, far parts that are not rectangles to 1e-2.
/// Weak when a low receiver looks past the polygon's plane at a steep angle: of a factor of 1e-12 the
///           middle keeps three digits.
/// Cost      0.3 us far away, 1.5 us nearby.
KernelMiddle kernel_middle(const Polygon& polygon, const PatchFrame& frame, const Receiver& receiver);

bool is_above_horizon(const Polygon& polygon, const Receiver& receiver);

/// Coefficients of the four nodes: F/4 (1 +- xi +- eta +- product), with the middle kept between the
/// nodes and the product where no coefficient is below 0.
/// Returns   four values of 0 or more that add up to the factor.
std::array<double, 4> node_shares(const KernelMiddle& seen);

}  // namespace hanei
