/// Opaque convex bodies, and which of them can stand between a point and a polygon.
#pragma once

#include "engine/base/vector.h"
#include "engine/geometry/body_shape.h"
#include "engine/geometry/body_tree.h"

#include <cstdint>
#include <span>
#include <vector>

namespace hanei {

/// A convex solid, or (one face, listed once) a flat convex polygon that is opaque from both sides.
struct ConvexBody {
    std::vector<Vec3> vertices;
    std::vector<std::vector<int>> faces;  ///< counter-clockwise seen from outside
    std::uint32_t owner = 0;              ///< ObjectId value of what it belongs to
    bool operator==(const ConvexBody&) const = default;
};

/// Number of a body in an OccluderSet.
using BodyIndex = std::uint32_t;

/// Bodies under a bounding volume hierarchy, with planes, edges and boxes worked out once.
///
/// A body hides what lies strictly beyond its surface: a sight line that runs along a face, touches
/// an edge or ends on the body is not blocked (open bodies, tolerance::same_place). Between bodies
/// that touch no light passes: a line in their contact is blocked, as those to either side of it are.
///
/// Holds     its own copy; immutable once built; any thread may ask.
class OccluderSet {
public:
    OccluderSet() = default;
    explicit OccluderSet(std::vector<ConvexBody> bodies);

    bool empty() const { return bodies_.empty(); }
    std::span<const ConvexBody> bodies() const { return bodies_; }

    /// Bodies that may hide part of the convex hull of `points` (a polygon, a line, one point) from
    /// `eye`: none is missed, a few too many may be named. Where one body is found to hide all of it,
    /// that one alone is named. Bodies of the owner `own` are left out (0: none is).
    /// Appends to `found`, in ascending order.
    void between(const Vec3& eye, std::span<const Vec3> points, std::vector<BodyIndex>& found,
                 std::uint32_t own = 0) const;

    /// Bodies that may hide something of `to` from some place of `from` (points of convex polygons):
    /// none is missed. When none is found, everything sees everything. Appends in ascending order.
    void between(std::span<const Vec3> from, std::span<const Vec3> to, std::vector<BodyIndex>& found) const;

    /// The same among bodies known to be all that can be in the way (ascending).
    void between(const Vec3& eye, std::span<const Vec3> points, std::span<const BodyIndex> among,
                 std::vector<BodyIndex>& found, std::uint32_t own = 0) const;

    /// Bodies that `between` may name for any eye in the box. Appends in ascending order.
    void between(const Box& eyes, std::span<const Vec3> points, std::vector<BodyIndex>& found) const;

    /// True when some body blocks the sight line between two places.
    bool blocks(const Vec3& from, const Vec3& to) const;
    bool blocks(const Vec3& from, const Vec3& to, std::span<const BodyIndex> candidates) const;

    /// The first body that strictly contains the place; -1 when none.
    int containing(const Vec3& place) const;

    const BodyShape& shape(BodyIndex body) const { return shapes_[body]; }

    /// Distance under which two places are one: tolerance::same_place of all bodies' extent.
    double same_place() const { return same_place_; }

private:
    void in_shaft(std::span<const Vec3> from, std::span<const Vec3> to, double touching,
                  std::vector<BodyIndex>& found) const;
    bool closes_contact(std::span<const BodyIndex> touched, const Vec3& from, const Vec3& to) const;
    bool hides(BodyIndex body, const Vec3& eye, std::span<const Vec3> points, std::uint32_t own) const;

    std::vector<ConvexBody> bodies_;
    std::vector<BodyShape> shapes_;
    BodyTree tree_;
    double same_place_ = 0.0;
};

}  // namespace hanei
