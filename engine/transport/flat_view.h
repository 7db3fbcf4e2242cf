/// A face as one receiver weighs it: the form factor of its parts, by quadrature in the plane.
#pragma once

#include "engine/transport/flat_loop.h"

namespace hanei {

/// The kernel of the form factor over a face, but for a factor that is the same all over it:
///
///     k(u, v) = max(0, rise + rise_u u + rise_v v) / ((u - eye_u)^2 + (v - eye_v)^2 + height^2)^2
///
/// the rise being that over the receiver's horizon.
struct FlatView {
    double eye_u = 0.0, eye_v = 0.0, height = 0.0;  ///< of the receiver: its foot, and how far it is off the plane
    double rise = 0.0, rise_u = 0.0, rise_v = 0.0;

    double rise_at(double u, double v) const { return rise + rise_u * u + rise_v * v; }
    double square_distance(double u, double v) const {
        return (u - eye_u) * (u - eye_u) + (v - eye_v) * (v - eye_v) + height * height;
    }

    /// How many times as far away as it is wide a place must be: its circle's radius over the distance.
    static constexpr double near = 0.25, nearest = 0.5;

    /// Integral of k over a convex loop above the horizon, by seven points a triangle (exact for
    /// polynomials of degree five); four times as many when `split`.
    ///
    /// Holds     a ratio of two such integrals to 1e-5 within `near`, split within `nearest`; the more so,
    ///           the smaller: the error falls with the sixth power.
    /// Weak when the coordinates are a million times as great as the loop: numbers are floats.
    double weight(const FlatLoop& loop, bool split) const;
};

}  // namespace hanei
