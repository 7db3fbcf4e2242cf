#include "engine/geometry/configuration_factor.h"

#include "engine/base/tolerance.h"
#include "engine/geometry/contour.h"
#include "engine/geometry/polygon.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace hanei {

namespace {

/// Calls `use` with the loop as the receiver sees it.
template <class Use>
double with_seen_loop(std::span<const Vec3> polygon, const Vec3& eye, Use&& use) {
    std::array<Vec3, 32> few;
    std::vector<Vec3> many;
    if (polygon.size() > few.size()) many.resize(polygon.size());
    const std::span<Vec3> offsets{many.empty() ? few.data() : many.data(), polygon.size()};
    for (std::size_t k = 0; k < polygon.size(); ++k) offsets[k] = polygon[k] - polygon[0];
    return use(SeenLoop{polygon[0] - eye, offsets});
}

/// A polygon or region seen from a receiver that may lie in its plane.
struct SeenShape {
    std::span<const Vec3> outline;
    std::span<const Polygon> holes;
    Vec3 front;       ///< unit normal
    double height;    ///< of the receiver over the plane, towards the front
    double touching;  ///< distance under which the receiver is on the plane or on an edge
};

template <class Loop>
double sum_over_loops(const SeenShape& shape, const Vec3& eye, Loop&& share) {
    double sum = with_seen_loop(shape.outline, eye, share);
    for (const Polygon& hole : shape.holes) {
        if (hole.size() >= 3) sum += with_seen_loop(hole, eye, share);
    }
    return sum;
}

/// Angle swept in the shape's plane around a point of it: about 2 pi inside, 0 outside.
double angle_around(const SeenShape& shape, const Vec3& point) {
    return sum_over_loops(shape, point, [&](const SeenLoop& loop) {
        double angle = 0.0;
        for (std::size_t k = 0; k < loop.size(); ++k) {
            const Vec3 a = loop.point(k);
            const Vec3 b = loop.point((k + 1) % loop.size());
            angle += std::atan2(glm::dot(glm::cross(a, b), shape.front), glm::dot(a, b));
        }
        return angle;
    });
}

double factor_in_plane(const SeenShape& shape, const Receiver& receiver) {
    const Vec3 rising = shape.front - receiver.normal * glm::dot(receiver.normal, shape.front);
    const bool facing_along = glm::length(rising) < 1e-6;
    Vec3 beside = receiver.inward;
    if (beside != Vec3{0.0}) {
        beside = glm::normalize(beside);
        const double leaving_plane = glm::dot(beside, shape.front);
        if (leaving_plane < -1e-6) return 0.0;
        if (leaving_plane <= 1e-6 && facing_along) {
            const Vec3 place = receiver.position + 8.0 * shape.touching * beside;
            if (std::abs(angle_around(shape, place)) < 3.0) return 0.0;
            return 0.5 * (1.0 - glm::dot(receiver.normal, shape.front));
        }
        if (leaving_plane <= 1e-6) beside = glm::normalize(beside + 1e-6 * glm::normalize(rising));
    } else {
        beside = facing_along ? shape.front : glm::normalize(rising);
    }
    return sum_over_loops(shape, receiver.position, [&](const SeenLoop& loop) {
        return contour_limit(loop, receiver.normal, shape.front, beside, shape.touching);
    });
}

double factor_of(std::span<const Vec3> outline, std::span<const Polygon> holes, const Receiver& receiver) {
    if (outline.size() < 3) return 0.0;
    const Vec3 area = vector_area(outline);
    const double size = glm::length(area);
    double farthest = 0.0;
    for (const Vec3& point : outline) {
        const Vec3 seen = point - receiver.position;
        farthest = std::max(farthest, glm::dot(seen, seen));
    }
    // A diameter is at most four times the farthest corner's distance; only what is that small is measured.
    if (!(size > tolerance::no_area * 16.0 * farthest)) {
        const double extent = diameter(outline);
        if (!(size > tolerance::no_area * extent * extent)) return 0.0;
    }
    farthest = std::sqrt(farthest);

    SeenShape shape{outline, holes, area / size, 0.0, touching_distance(receiver, farthest)};
    shape.height = glm::dot(receiver.position - outline[0], shape.front);
    if (shape.height < -shape.touching) return 0.0;
    const double factor = shape.height <= shape.touching
                              ? factor_in_plane(shape, receiver)
                              : sum_over_loops(shape, receiver.position, [&](const SeenLoop& loop) {
                                    return contour_factor(loop, receiver.normal);
                                });
    return std::clamp(factor, 0.0, 1.0);
}

}  // namespace

double configuration_factor(std::span<const Vec3> polygon, const Receiver& receiver) {
    return factor_of(polygon, {}, receiver);
}

double configuration_factor(const Region& region, const Receiver& receiver) {
    return factor_of(region.outline, region.holes, receiver);
}

}  // namespace hanei
