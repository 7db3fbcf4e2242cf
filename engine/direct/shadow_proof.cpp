#include "engine/direct/shadow_proof.h"

#include "engine/geometry/convex_hull.h"
#include "engine/geometry/polygon.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace hanei {

namespace {

constexpr std::size_t most_planes = 24;  // more bodies than 8 boxes: a wall of books, not worth the search

Vec3 middle_of(std::span<const Vec3> points) {
    Vec3 sum{0.0};
    for (const Vec3& point : points) sum += point;
    return sum / static_cast<double>(points.size());
}

/// A place inside that seams of bodies hardly ever run through.
Vec3 odd_place_in(std::span<const Vec3> points) {
    Vec3 sum{0.0};
    double weights = 0.0;
    for (std::size_t k = 0; k < points.size(); ++k) {
        const double weight = 1.0 + 0.17 * std::sin(2.4 * static_cast<double>(k + 1));
        sum += weight * points[k];
        weights += weight;
    }
    return sum / weights;
}

/// A sight line found free: no proof is to be looked for.
bool see_each_other(const SightQuestion& q) {
    const Vec3 a = odd_place_in(q.from), b = odd_place_in(q.to);
    const auto is_free = [&](const Vec3& from, const Vec3& to) { return !q.occluders.blocks(from, to, q.among); };
    return is_free(a, b) ||
           std::ranges::any_of(q.from, [&](const Vec3& corner) { return is_free(glm::mix(corner, a, 0.1), b); }) ||
           std::ranges::any_of(q.to, [&](const Vec3& corner) { return is_free(a, glm::mix(corner, b, 0.1)); });
}

/// Where the lines between corners cross the plane: their hull. Empty when the plane does not
/// stand between the two.
Polygon crossings(const SightQuestion& q, const Plane& plane) {
    const double touching = q.occluders.same_place();
    double side = 0.0;
    for (const Vec3& point : q.from) {
        const double height = plane.height(point);
        if (std::abs(height) > std::abs(side)) side = height;
    }
    side = side > 0.0 ? 1.0 : -1.0;
    const auto beyond = [&](const Vec3& point) { return side * plane.height(point) < -touching; };
    const auto before = [&](const Vec3& point) { return side * plane.height(point) >= -touching; };
    if (!std::ranges::all_of(q.to, beyond) || !std::ranges::all_of(q.from, before)) return {};
    std::vector<Vec3> places;
    for (const Vec3& a : q.from) {
        for (const Vec3& b : q.to) {
            const double start = std::max(0.0, side * plane.height(a)), end = side * plane.height(b);
            places.push_back(a + (start / (start - end)) * (b - a));
        }
    }
    return convex_hull(places, plane.normal);
}

Polygon section_of(const OccluderSet& occluders, BodyIndex body, const Plane& plane) {
    const BodyShape& shape = occluders.shape(body);
    std::vector<Vec3> places;
    for (const BodyEdge& edge : shape.edges) {
        const double start = plane.height(edge.from), end = plane.height(edge.to);
        if (shape.flat) {
            if (std::abs(start) > occluders.same_place()) return {};
            places.push_back(edge.from);
        } else if ((start < 0.0) != (end < 0.0)) {
            places.push_back(edge.from + (start / (start - end)) * (edge.to - edge.from));
        }
    }
    return convex_hull(places, plane.normal);
}

bool is_hidden_across(const SightQuestion& q, const Plane& plane) {
    std::vector<Polygon> open{crossings(q, plane)};
    if (open[0].empty()) return false;
    for (const BodyIndex body : q.among) {
        const Polygon section = section_of(q.occluders, body, plane);
        if (section.empty()) continue;
        std::vector<Polygon> left;
        for (const Polygon& part : open)
            std::ranges::move(subtracted(part, section, q.occluders.same_place()), std::back_inserter(left));
        open = std::move(left);
        if (open.empty()) return true;
    }
    return false;
}

/// Planes through the middles of the bodies, along their faces.
bool is_hidden_across_some_plane(const SightQuestion& q) {
    std::vector<Plane> tried;
    for (const BodyIndex body : q.among) {
        const BodyShape& shape = q.occluders.shape(body);
        const Vec3 middle = shape.flat ? shape.faces[0].point : middle_of(q.occluders.bodies()[body].vertices);
        for (const BodyFace& face : shape.faces) {
            const bool known = std::ranges::any_of(tried, [&](const Plane& plane) {
                return std::abs(glm::dot(plane.normal, face.normal)) > 1.0 - 1e-9 &&
                       std::abs(plane.height(middle)) <= q.occluders.same_place();
            });
            if (known) continue;
            if (tried.size() == most_planes) return false;
            tried.push_back({middle, face.normal});
            if (is_hidden_across(q, tried.back())) return true;
        }
    }
    return false;
}

/// Two halves of a polygon across its longest side, or of a line; a point stays one.
std::vector<Polygon> halves_of(std::span<const Vec3> points) {
    if (points.size() == 1) return {Polygon(points.begin(), points.end())};
    const Vec3 middle = middle_of(points);
    if (points.size() == 2) return {{points[0], middle}, {middle, points[1]}};
    Vec3 longest{0.0};
    for (std::size_t k = 0; k < points.size(); ++k) {
        const Vec3 side = points[(k + 1) % points.size()] - points[k];
        if (glm::length(side) > glm::length(longest)) longest = side;
    }
    const Vec3 across = glm::normalize(longest);
    const Polygon whole(points.begin(), points.end());
    return {clipped(whole, {middle, across}, 0.0), clipped(whole, {middle, -across}, 0.0)};
}

}  // namespace

bool is_hidden_by_one(const SightQuestion& q) {
    const Vec3 a = middle_of(q.from), b = middle_of(q.to);
    return std::ranges::any_of(q.among, [&](const BodyIndex& body) {
        const std::span<const BodyIndex> alone(&body, 1);
        return q.occluders.blocks(a, b, alone) && std::ranges::all_of(q.from, [&](const Vec3& eye) {
                   return std::ranges::all_of(q.to,
                                              [&](const Vec3& seen) { return q.occluders.blocks(eye, seen, alone); });
               });
    });
}

bool is_hidden_by_several(const SightQuestion& q, int halvings) {
    if (q.among.size() < 2 || see_each_other(q)) return false;
    if (is_hidden_across_some_plane(q)) return true;
    if (halvings == 0) return false;
    const std::vector<Polygon> to_halves = halves_of(q.to);
    for (const Polygon& from : halves_of(q.from)) {
        for (const Polygon& to : to_halves) {
            if (from.empty() || to.empty()) continue;
            const SightQuestion part{from, to, q.occluders, q.among};
            if (!is_hidden_by_one(part) && !is_hidden_by_several(part, halvings - 1)) return false;
        }
    }
    return true;
}

}  // namespace hanei
