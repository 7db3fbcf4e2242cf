/// What a convex body hides from an eye, as an intersection of half-spaces.
#pragma once

#include "engine/geometry/body_shape.h"

#include <span>
#include <vector>

namespace hanei {

/// The places x (seen from the eye) with outward . x < reach. Not normalised.
struct HalfSpace {
    Vec3 outward{0.0};
    double reach = 0.0;
    double slack = 0.0;  ///< a place must be deeper than this to be inside
};

enum class Hides { nothing, everything, region };

/// The region hidden from `eye`: behind the faces turned to the eye, and inside the planes through
/// the eye and the silhouette. For an eye on the body's surface: inside the planes it lies on.
///
///     hidden = intersection of { behind face f : eye before f } and { inside silhouette plane s }
///
/// It is open: the body's own faces and the silhouette planes are not in it.
///
/// Needs     `same_place`, the distance under which the eye is on a plane; `beside`, the direction
///           from which the eye was reached when it lies on a flat body's edge, zero when free.
/// Returns   the half-spaces in `planes` (overwritten) when the answer is `region`.
Hides hidden_region(const BodyShape& shape, const Vec3& eye, const Vec3& beside, double same_place,
                    std::vector<HalfSpace>& planes);

/// True when the body hides all of the hull of `points`, by `margin` at least: what a convex body hides
/// is convex, so their corners decide.
bool hides_all(const BodyShape& shape, const Vec3& eye, std::span<const Vec3> points, double margin);

}  // namespace hanei
