#include "engine/geometry/enclosure.h"

#include <algorithm>
#include <cmath>

namespace hanei {

namespace {

double components(const Vec3& v) { return std::abs(v.x) + std::abs(v.y) + std::abs(v.z); }

/// Where points lie along a direction.
struct Extent {
    double low, high;
    void include(double along) {
        low = std::min(low, along);
        high = std::max(high, along);
    }
};

void add_side(Enclosure& region, const Vec3& outward, double reach) {
    if (region.count < region.sides.size()) region.sides[region.count++] = {outward, reach};
}

/// Of a plane through the origin, the side on which nothing of the region lies.
void add_free_side(Enclosure& region, const Vec3& across, const Extent& extent, double margin) {
    if (extent.high <= -extent.low) {
        add_side(region, across, extent.high + margin);
    } else {
        add_side(region, -across, margin - extent.low);
    }
}

void add_both_sides(Enclosure& region, const Vec3& across, const Extent& extent, double margin) {
    add_side(region, across, extent.high + margin);
    add_side(region, -across, margin - extent.low);
}

/// Of the eye, at 0, and the points along a direction.
Extent extent_along(const Vec3& direction, const Vec3& eye, std::span<const Vec3> points) {
    Extent extent{0.0, 0.0};
    for (const Vec3& point : points) extent.include(glm::dot(direction, point - eye));
    return extent;
}

/// Sides of the hull of two polygons.
class ShaftSides {
public:
    ShaftSides(std::span<const Vec3> from, std::span<const Vec3> to, double touching, Enclosure& region)
        : from_(from), to_(to), touching_(touching), region_(region) {}

    /// Planes through an edge of one polygon and a corner of the other.
    void across(std::span<const Vec3> edges, std::span<const Vec3> corners) {
        if (edges.size() < 2) return;
        const std::size_t sides = std::min<std::size_t>(edges.size(), 8);
        for (std::size_t side = 0; side < sides; ++side) {
            const std::size_t k = side * edges.size() / sides;
            const Vec3 edge = edges[(k + 1) % edges.size()] - edges[k];
            for (const Vec3& corner : corners) {
                const Vec3 normal = glm::cross(edge, corner - edges[k]);
                const Extent extent = extent_from(normal, edges[k]);
                // Only planes with the whole shaft on one side keep anything out.
                if (extent.low < -1e-9 * extent.high && extent.high > -1e-9 * extent.low) continue;
                const double length = glm::length(normal);
                if (length == 0.0) continue;
                const Vec3 outward = (extent.high <= -extent.low ? 1.0 : -1.0) / length * normal;
                add_side(region_, outward, extent_from(outward, from_[0]).high - touching_);
            }
        }
    }

    void facing(std::span<const Vec3> polygon) {
        if (polygon.size() < 3) return;
        const Vec3 normal = glm::cross(polygon[1] - polygon[0], polygon[2] - polygon[0]);
        const double length = glm::length(normal);
        if (length == 0.0) return;
        add_both_sides(region_, normal / length, extent_from(normal / length, from_[0]), -touching_);
    }

private:
    Extent extent_from(const Vec3& direction, const Vec3& origin) const {
        Extent extent{0.0, 0.0};
        for (const Vec3& point : from_) extent.include(glm::dot(direction, point - origin));
        for (const Vec3& point : to_) extent.include(glm::dot(direction, point - origin));
        return extent;
    }

    std::span<const Vec3> from_, to_;
    double touching_;
    Enclosure& region_;
};

}  // namespace

bool Enclosure::may_reach(const Box& box) const {
    if (box.low.x > bounds.high.x || box.low.y > bounds.high.y || box.low.z > bounds.high.z) return false;
    if (box.high.x < bounds.low.x || box.high.y < bounds.low.y || box.high.z < bounds.low.z) return false;
    const Vec3 centre = box.centre() - origin;
    const Vec3 half = box.half_size();
    return std::ranges::none_of(planes(), [&](const Side& side) {
        return glm::dot(side.outward, centre) - glm::dot(glm::abs(side.outward), half) > side.reach;
    });
}

void enclose_pyramid(const Vec3& eye, std::span<const Vec3> points, double margin, Enclosure& region) {
    region.bounds = {eye, eye};
    region.origin = eye;
    region.forward = Vec3{0.0};
    region.count = 0;
    for (const Vec3& point : points) {
        region.bounds.include(point);
        region.forward += point - eye;
    }
    region.bounds.low -= Vec3{margin};
    region.bounds.high += Vec3{margin};
    // A direction is no longer than its components together: margins are at least `margin` in metres.
    if (points.size() == 1) {
        const Vec3 along = points[0] - eye;
        for (const Vec3& across : {Vec3{0.0, along.z, -along.y}, {-along.z, 0.0, along.x}, {along.y, -along.x, 0.0}}) {
            add_both_sides(region, across, {0.0, 0.0}, margin * components(across));
        }
        return;
    }
    const std::size_t sides = points.size() == 2 ? 1 : std::min<std::size_t>(points.size(), 8);
    for (std::size_t side = 0; side < sides; ++side) {
        const std::size_t k = side * points.size() / sides;
        const Vec3 across = glm::cross(points[k] - eye, points[k + 1 < points.size() ? k + 1 : 0] - eye);
        const Extent extent = extent_along(across, eye, points);
        const double wide = margin * components(across);
        if (points.size() == 2) add_both_sides(region, across, extent, wide);
        if (points.size() > 2) add_free_side(region, across, extent, wide);
    }
    if (points.size() > 2) {
        const Vec3 normal = glm::cross(points[1] - points[0], points[2] - points[0]);
        const Extent extent = extent_along(normal, eye, points);
        const double wide = margin * components(normal);
        if (extent.high >= -extent.low) {  // only what lies beyond the points: behind the eye the others keep it out
            add_side(region, normal, extent.high + wide);
        } else {
            add_side(region, -normal, wide - extent.low);
        }
    }
}

void enclose_shaft(std::span<const Vec3> from, std::span<const Vec3> to, double touching, Enclosure& region) {
    region.bounds = {from[0], from[0]};
    for (const Vec3& point : from) region.bounds.include(point);
    for (const Vec3& point : to) region.bounds.include(point);
    region.bounds.low += Vec3{touching};
    region.bounds.high -= Vec3{touching};
    region.origin = from[0];
    region.forward = Vec3{0.0};
    region.count = 0;
    ShaftSides shaft(from, to, touching, region);
    shaft.across(from, to);
    shaft.across(to, from);
    shaft.facing(from);
    shaft.facing(to);
}

}  // namespace hanei
