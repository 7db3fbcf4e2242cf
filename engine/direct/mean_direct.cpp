#include "engine/base/tiles.h"
#include "engine/direct/direct.h"
#include "engine/direct/light_class.h"

#include <algorithm>
#include <array>

namespace hanei {

namespace {

/// How often a cell is cut into four where the light on it is uneven (64 points a quadrilateral at
/// most), and where a shadow may lie on it (16 at least, or a chair's leg falls between the points).
constexpr int finest_level = 2;
constexpr int shadow_level = 1;

/// Gauss points of a smooth cell err by about the fourth power of the spread; at the rim of a penumbra,
/// where light begins to fall, by a fifth of it.
constexpr double smooth_spread = 0.05;
constexpr double of_smooth = 0.05;  // of the spread's square over the greatest value
constexpr double of_shadow = 0.5;   // of the spread

/// Part of a patch: a quadrilateral, or a triangle (its last two corners are one).
struct Cell {
    std::array<Vec3, 4> corners;
    bool triangle = false;
};

std::array<Cell, 4> quarters(const Cell& cell) {
    const auto& [a, b, c, d] = cell.corners;
    const Vec3 ab = 0.5 * (a + b), bc = 0.5 * (b + c), cd = 0.5 * (c + d), da = 0.5 * (d + a);
    if (cell.triangle) {
        const Vec3 ca = 0.5 * (c + a);
        return {Cell{{a, ab, ca, ca}, true}, Cell{{ab, b, bc, bc}, true}, Cell{{ca, bc, c, c}, true},
                Cell{{bc, ca, ab, ab}, true}};
    }
    const Vec3 middle = 0.25 * (a + b + c + d);
    return {Cell{{a, ab, middle, da}, false}, Cell{{ab, b, bc, middle}, false}, Cell{{middle, bc, c, cd}, false},
            Cell{{da, middle, cd, d}, false}};
}

/// A place of a cell and the area it stands for.
struct Sample {
    Vec3 place;
    double area;
};

Sample on_quadrilateral(const Cell& cell, double u, double v) {
    const auto& [a, b, c, d] = cell.corners;
    const Vec3 along = (1.0 - v) * (b - a) + v * (c - d);
    const Vec3 across = (1.0 - u) * (d - a) + u * (c - b);
    const Vec3 place = a + u * (b - a) + v * (d - a) + (u * v) * ((a - b) + (c - d));
    return {place, 0.25 * glm::length(glm::cross(along, across))};
}

/// The Gauss points of a cell: exact for cubics over a quadrilateral, for quadratics over a triangle.
std::size_t samples_of(const Cell& cell, std::array<Sample, 4>& samples) {
    if (cell.triangle) {
        const auto& [a, b, c, same] = cell.corners;
        const double third = glm::length(glm::cross(b - a, c - a)) / 6.0;
        samples[0] = {(4.0 * a + b + c) / 6.0, third};
        samples[1] = {(a + 4.0 * b + c) / 6.0, third};
        samples[2] = {(a + b + 4.0 * c) / 6.0, third};
        return 3;
    }
    constexpr double near = 0.21132486540518713, far = 1.0 - near;  // (1 -+ 1/sqrt 3) / 2
    samples = {on_quadrilateral(cell, near, near), on_quadrilateral(cell, far, near), on_quadrilateral(cell, near, far),
               on_quadrilateral(cell, far, far)};
    return 4;
}

/// Flux on a cell, by how much it may be off, and the cell's area.
struct Sum {
    double flux = 0.0;
    double error = 0.0;
    double area = 0.0;
    void operator+=(const Sum& other) {
        flux += other.flux;
        error += other.error;
        area += other.area;
    }
};

/// An emitter and the bodies that can stand between it and one polygon.
struct Light {
    const Emitter& emitter;
    const OccluderSet* occluders;
    std::span<const BodyIndex> bodies;
    Accuracy accuracy;

    Estimate at(const Receiver& receiver) const {
        if (bodies.empty()) return emitter.estimate(receiver, nullptr, accuracy);
        return emitter.estimate(receiver, *occluders, bodies, accuracy);
    }
};

struct Sampled {
    Sum sum;
    double least = 0.0, greatest = 0.0;

    double spread() const { return greatest - least; }
};

Sampled sampled(const Cell& cell, const Vec3& normal, const Light& light) {
    std::array<Sample, 4> samples;
    const std::size_t count = samples_of(cell, samples);
    Sampled all;
    for (std::size_t k = 0; k < count; ++k) {
        const Estimate here = light.at({samples[k].place, normal, Vec3{0.0}});
        all.least = k == 0 ? here.value : std::min(all.least, here.value);
        all.greatest = std::max(all.greatest, here.value);
        all.sum += {here.value * samples[k].area, here.error * samples[k].area, samples[k].area};
    }
    return all;
}

Sum in_quarters(const Cell& cell, const Vec3& normal, const Light& light, int levels);

Sum arriving_on(const Cell& cell, const Vec3& normal, const Light& light, int levels) {
    const bool shadowed = !light.bodies.empty();
    if (shadowed && levels > finest_level - shadow_level) return in_quarters(cell, normal, light, levels);
    Sampled coarse = sampled(cell, normal, light);
    const double spread = coarse.spread();
    const double smooth =
        shadowed ? of_shadow * spread : of_smooth * spread * spread / std::max(coarse.greatest, 1e-300);
    const double off = smooth * coarse.sum.area;
    if (levels == 0 || spread <= smooth_spread * coarse.greatest ||
        off <= light.accuracy.allowed(coarse.sum.flux / coarse.sum.area) * coarse.sum.area) {
        coarse.sum.error += off;
        return coarse.sum;
    }
    return in_quarters(cell, normal, light, levels);
}

Sum in_quarters(const Cell& cell, const Vec3& normal, const Light& light, int levels) {
    Sum sum;
    for (const Cell& quarter : quarters(cell)) sum += arriving_on(quarter, normal, light, levels - 1);
    return sum;
}

Estimate mean_on(const ReceivingPolygon& polygon, const Emitter& emitter, const OccluderSet* occluders,
                 const Accuracy& accuracy) {
    thread_local std::vector<BodyIndex> between;
    if (is_unlit(classify(polygon, emitter, occluders, std::nullopt, between))) return {};
    const Light light{emitter, occluders, between, accuracy};
    const std::span<const Vec3> corners = polygon.outline;
    Sum sum;
    if (corners.size() == 4) {
        const Cell whole{{corners[0], corners[1], corners[2], corners[3]}, false};
        sum = arriving_on(whole, polygon.normal, light, finest_level);
    } else {
        for (std::size_t k = 2; k < corners.size(); ++k) {
            const Cell part{{corners[0], corners[k - 1], corners[k], corners[k]}, true};
            sum += arriving_on(part, polygon.normal, light, finest_level);
        }
    }
    return sum.area > 0.0 ? Estimate{sum.flux / sum.area, sum.error / sum.area} : Estimate{};
}

}  // namespace

std::optional<std::vector<double>> mean_direct_estimates(const Emitter& emitter,
                                                         std::span<const ReceivingPolygon> polygons,
                                                         const OccluderSet* occluders, const Accuracy& accuracy,
                                                         const Work& work) {
    std::vector<double> means(2 * polygons.size());
    const bool finished = for_each_tile(polygons.size(), 16, work, [&](std::size_t begin, std::size_t end) {
        for (std::size_t k = begin; k < end; ++k) {
            const Estimate mean = mean_on(polygons[k], emitter, occluders, accuracy);
            means[k] = mean.value;
            means[polygons.size() + k] = mean.error;
        }
    });
    if (!finished) return std::nullopt;
    return means;
}

std::optional<std::vector<double>> mean_direct_illuminance(const Emitter& emitter,
                                                           std::span<const ReceivingPolygon> polygons,
                                                           const OccluderSet* occluders, const Work& work) {
    auto means = mean_direct_estimates(emitter, polygons, occluders, Accuracy{}, work);
    if (means) means->resize(polygons.size());
    return means;
}

}  // namespace hanei
