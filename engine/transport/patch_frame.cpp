#include "engine/transport/patch_frame.h"

#include "engine/geometry/polygon.h"

#include <algorithm>
#include <cmath>

namespace hanei {

namespace {

/// Moments of area in two directions, about a place.
struct Moments {
    double area = 0.0;
    Vec2 first{0.0};
    double uu = 0.0, vv = 0.0, uv = 0.0;
};

Moments moments_of(std::span<const Vec3> polygon, const Vec3& about, const Vec3& u, const Vec3& v) {
    const auto flat = [&](const Vec3& p) { return Vec2{glm::dot(p - about, u), glm::dot(p - about, v)}; };
    Moments sum;
    for (std::size_t k = 2; k < polygon.size(); ++k) {
        const Vec2 a = flat(polygon[0]), b = flat(polygon[k - 1]), c = flat(polygon[k]);
        const double area = 0.5 * ((b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x));
        const Vec2 all = a + b + c;
        sum.area += area;
        sum.first += area / 3.0 * all;
        sum.uu += area / 12.0 * (a.x * a.x + b.x * b.x + c.x * c.x + all.x * all.x);
        sum.vv += area / 12.0 * (a.y * a.y + b.y * b.y + c.y * c.y + all.y * all.y);
        sum.uv += area / 12.0 * (a.x * a.y + b.x * b.y + c.x * c.y + all.x * all.y);
    }
    return sum;
}

Vec3 longest_edge(std::span<const Vec3> polygon) {
    Vec3 longest{0.0};
    for (std::size_t k = 0; k < polygon.size(); ++k) {
        const Vec3 edge = polygon[(k + 1) % polygon.size()] - polygon[k];
        // edges as long but for rounding: the first
        if (glm::dot(edge, edge) > (1.0 + 1e-9) * glm::dot(longest, longest)) longest = edge;
    }
    return glm::normalize(longest);
}

}  // namespace

Vec2 PatchFrame::coordinates(const Vec3& place) const {
    const Vec3 from_centre = place - centre;
    return {glm::dot(from_centre, along) / glm::dot(along, along),
            glm::dot(from_centre, across) / glm::dot(across, across)};
}

PatchFrame frame_of(std::span<const Vec3> polygon, const Vec3& normal, const Vec3& wished) {
    PatchFrame frame;
    frame.centre = centroid(polygon);
    const Vec3 u = longest_edge(polygon);
    const Vec3 v = glm::cross(normal, u);
    const Moments about = moments_of(polygon, frame.centre, u, v);
    const double uu = about.uu / about.area, vv = about.vv / about.area, uv = about.uv / about.area;
    const bool on_edges = std::abs(uv) <= 1e-9 * (uu + vv);  // rounding must not turn the axes of a square
    const double turn = on_edges ? 0.0 : 0.5 * std::atan2(2.0 * uv, uu - vv);
    const double c = std::cos(turn), s = std::sin(turn);
    Vec3 first = c * u + s * v, second = c * v - s * u;
    double spread_first = c * c * uu + s * s * vv + 2.0 * c * s * uv;
    double spread_second = uu + vv - spread_first;
    if (std::abs(glm::dot(second, wished)) > std::abs(glm::dot(first, wished))) {
        std::swap(first, second);
        std::swap(spread_first, spread_second);
    }
    if (glm::dot(first, wished) < 0.0) first = -first;
    frame.along = std::sqrt(spread_first) * first;
    frame.across = std::sqrt(spread_second) * glm::cross(normal, first);
    return frame;
}

std::array<Polygon, 4> quarters_of(const Polygon& polygon, const PatchFrame& frame) {
    const Vec3 along = glm::normalize(frame.along), across = glm::normalize(frame.across);
    std::array<Polygon, 4> quarters;
    for (unsigned side = 0; side < 2; ++side) {
        const Polygon half = clipped(polygon, {frame.centre, side == 1 ? along : -along}, 0.0);
        quarters[side] = clipped(half, {frame.centre, -across}, 0.0);
        quarters[side + 2] = clipped(half, {frame.centre, across}, 0.0);
    }
    return quarters;
}

FrameMeans means_over(std::span<const Vec3> part, const PatchFrame& frame) {
    const double square_along = glm::dot(frame.along, frame.along);
    const double square_across = glm::dot(frame.across, frame.across);
    const Moments sum = moments_of(part, frame.centre, frame.along / square_along, frame.across / square_across);
    // the moments are in units of the frame: an area of 1 there is one deviation each way
    return {sum.area * std::sqrt(square_along * square_across), sum.first.x / sum.area, sum.first.y / sum.area,
            sum.uv / sum.area};
}

}  // namespace hanei
