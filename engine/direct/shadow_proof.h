/// Proofs that bodies hide one convex set of points from another.
#pragma once

#include "engine/geometry/occluders.h"

#include <span>

namespace hanei {

/// What may see each other: corners of convex polygons, ends of a line, or one point; and the bodies
/// that can be in the way (ascending).
struct SightQuestion {
    std::span<const Vec3> from, to;
    const OccluderSet& occluders;
    std::span<const BodyIndex> among;
};

/// True when one body alone hides everything from everything. What a convex body hides from a point is
/// convex, towards either side, so that the sight lines between corners tell all.
bool is_hidden_by_one(const SightQuestion& question);

/// True when it is proved that several bodies together hide everything from everything.
///
/// Every sight line passes a plane between the two within the hull of the crossings of the corners'
/// lines: bodies whose sections with the plane cover that hull hide everything. The planes tried run
/// through the middles of the bodies, along their faces. Where none does, both sides are halved,
/// `halvings` times at most, and the parts are proved one by one.
///
/// Returns   true also where light could pass along the seam of bodies that touch.
/// Weak when bodies hide together that lie one behind the other: false is no proof.
/// Cost      0.2 us where a free sight line is soon found, some us a body for a proof.
bool is_hidden_by_several(const SightQuestion& question, int halvings);

}  // namespace hanei
