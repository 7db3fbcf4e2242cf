#include "engine/direct/mean_cell.h"

#include "engine/direct/obstacles.h"
#include "engine/geometry/polygon.h"
#include "engine/geometry/visible_part.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace hanei {

namespace {

// What nodes leave open, as shares of how they differ. Four nodes are exact for quadratics: in smooth light
// they err by some hundredths of the spread's square, at the rim of a shadow by a part of the spread.
constexpr double of_smooth = 0.015;  // of the spread's square over the mean
constexpr double of_kinks = 0.002;   // of the spread, where tables are bent
constexpr double of_shadow = 0.25;   // of the spread between nodes that see all, some or none
constexpr double of_shares = 0.045;  // of the spread between the shares of a patch seen from an opening's nodes
constexpr double of_one = 0.15;      // of the light itself, where its centre stands for the opening
constexpr double of_kinked = 0.08;   // of it where a node sees all or nothing
constexpr double of_slight = 0.25;   // more of it where these hardly differ: a rim that one node just notices
constexpr double of_rims = 0.12;     // of what only the opening's corners see, or do not see

constexpr double of_uniform = 0.3;  // of these, where no table bends the light
constexpr double of_near = 0.1;     // of the light itself, where a cell is as wide as it is far

/// Of the light itself: peaks between the nodes of cells nearer to the light than they are wide. Without
/// `on_patch` the nodes are the opening's alone.
double share_of_near(const FlatCell& patch, bool on_patch, const FlatCell* opening, std::span<const Vec3> source) {
    double nearest = std::numeric_limits<double>::infinity();
    for (std::size_t k = 0; k < source.size(); ++k) {
        const Vec3 from = source[k] - patch.centre, along = source[(k + 1) % source.size()] - source[k];
        const double square = glm::dot(along, along);
        const double at = square > 0.0 ? std::clamp(-glm::dot(from, along) / square, 0.0, 1.0) : 0.0;
        const Vec3 place = from + at * along;
        nearest = std::min(nearest, glm::dot(place, place));
    }
    double size = on_patch ? glm::dot(patch.along, patch.along) : 0.0;
    if (opening) {
        const Vec3 away = opening->centre - patch.centre;
        nearest = std::min(nearest, glm::dot(away, away));
        size += glm::dot(opening->along, opening->along);
    }
    const double ratio = nearest > 0.0 ? std::min(1.0, size / nearest) : 1.0;
    return of_near * ratio * ratio;
}

double error_of_smooth(double spread, double mean) {
    return mean > 0.0 ? of_smooth * spread * spread / mean + of_kinks * spread : 0.0;
}

struct Spread {
    double least = 0.0, greatest = 0.0;
    bool any = false;
    void include(double value) {
        least = any ? std::min(least, value) : value;
        greatest = any ? std::max(greatest, value) : value;
        any = true;
    }
    double value() const { return greatest - least; }
};

/// What a place of the opening gives to the part of a cell that it sees.
struct Seen {
    double share = 0.0;   ///< of the cell's area
    double light = 0.0;   ///< mean illuminance over the whole cell
    double spread = 0.0;  ///< greatest within a part
};

Seen seen_from(const Vec3& place, const ShadowedCell& cell, const LightOnPatch& light) {
    thread_local std::vector<BodyIndex> between;
    const Obstacles obstacles{light.occluders, light.emitter.luminaire().value, light.bodies};
    obstacles.between(place, cell.patch.corners, between);
    if (between.empty()) {
        const PlaceLight whole = light.emitter.from_place(cell.piece, place, cell.patch, light.normal);
        return {1.0, whole.mean, whole.spread};
    }
    Seen seen;
    for (Polygon& part : visible_part(cell.patch.corners, place, *light.occluders, between)) {
        const FlatCell visible =
            light.emitter.is_uniform() ? FlatCell::without_nodes(std::move(part)) : FlatCell(std::move(part));
        const double share = visible.size / cell.patch.size;
        const PlaceLight here = light.emitter.from_place(cell.piece, place, visible, light.normal);
        seen.share += share;
        seen.light += share * here.mean;
        seen.spread = std::max(seen.spread, here.spread);
    }
    return seen;
}

double seen_share(const Vec3& place, const ShadowedCell& cell, const LightOnPatch& light) {
    thread_local std::vector<BodyIndex> between;
    const Obstacles obstacles{light.occluders, light.emitter.luminaire().value, light.bodies};
    obstacles.between(place, cell.patch.corners, between);
    if (between.empty()) return 1.0;
    double seen = 0.0;
    for (const Polygon& part : visible_part(cell.patch.corners, place, *light.occluders, between))
        seen += glm::length(vector_area(part)) / cell.patch.size;
    return seen;
}

/// How much more or less of the cell the opening's corners see than its nodes, which all see the same.
double unnoticed_at_nodes(double share, const ShadowedCell& cell, const LightOnPatch& light) {
    double most = 0.0;
    for (const Vec3& corner : cell.opening.corners)
        most = std::max(most, std::abs(seen_share(corner, cell, light) - share));
    return most;
}

}  // namespace

void ReceivingCell::measure(const LightOnPatch& light) {
    mean = {};
    if (patch.count == 0) return;
    Spread spread;
    for (const Vec3& node : patch.nodes()) {
        const Receiver receiver{node, light.normal, Vec3{0.0}};
        const Estimate here = light.bodies.empty()
                                  ? light.emitter.estimate(receiver, nullptr, light.accuracy)
                                  : light.emitter.estimate(receiver, *light.occluders, light.bodies, light.accuracy);
        spread.include(here.value);
        mean.value += here.value;
        mean.error += here.error;
    }
    const double share = weight / static_cast<double>(patch.count);
    const double middle = mean.value / static_cast<double>(patch.count);
    mean = {share * mean.value, share * mean.error};
    const double smooth = light.bodies.empty() ? error_of_smooth(spread.value(), middle) : of_shadow * spread.value();
    mean.error += weight * (smooth + share_of_near(patch, true, nullptr, light.emitter.extent()) * middle);
}

std::vector<ReceivingCell> ReceivingCell::halves() const {
    std::vector<ReceivingCell> parts;
    for (FlatCell& half : patch.halves()) {
        const double share = half.size / patch.size;
        parts.push_back({std::move(half), weight * share, {}});
    }
    return parts;
}

void ShadowedCell::measure(const LightOnPatch& light) {
    mean = {};
    if (patch.count == 0 || opening.count == 0) return;
    if (next == Next::nodes && opening.count > 1) return measure_from_centre(light);
    Spread shares, values;
    double within = 0.0, shared = 0.0;
    for (const Vec3& node : opening.nodes()) {
        const Seen seen = seen_from(node, *this, light);
        mean.value += seen.light;
        shared += seen.share;
        shares.include(seen.share);
        if (seen.share > 0.0) values.include(seen.light / seen.share);
        within = std::max(within, seen.spread);
    }
    const auto count = static_cast<double>(opening.count);
    mean.value *= weight / count;
    double differ = of_shares * shares.value();
    if (shares.least <= 0.0 || shares.greatest >= 1.0)
        differ = (of_kinked + of_slight * std::pow(1.0 - std::min(1.0, shares.value()), 4)) * shares.value();
    if (opening.count > 1 && !light.bodies.empty() && shares.value() == 0.0)
        differ = of_rims * unnoticed_at_nodes(shares.least, *this, light);
    double unhidden = 0.5 * (values.least + values.greatest);
    if (!(shared > 0.0) && differ > 0.0)
        unhidden = light.emitter.from_place(piece, opening.centre, patch, light.normal).mean;
    const double near = share_of_near(patch, !light.emitter.is_uniform(), &opening, opening.corners) * unhidden;
    const double seen = shared / count;
    double of_patch = error_of_smooth(within, unhidden) * seen;
    const double uneven = error_of_smooth(values.value(), unhidden) * seen;
    double of_opening = (light.emitter.is_uniform() ? of_uniform * uneven : uneven) + differ * unhidden;
    (light.emitter.is_uniform() ? of_opening : of_patch) += near * seen;
    next = of_opening > of_patch && opening.count > 1 ? Next::opening : Next::patch;
    mean.error = weight * (of_patch + of_opening);
}

void ShadowedCell::measure_from_centre(const LightOnPatch& light) {
    const PlaceLight whole = light.emitter.from_place(piece, opening.centre, patch, light.normal);
    double share = 1.0;
    if (!light.bodies.empty()) {
        share = seen_share(opening.centre, *this, light);
    }
    mean = {weight * share * whole.mean, weight * of_one * whole.mean};
}

std::vector<ShadowedCell> ShadowedCell::halves() const {
    std::vector<ShadowedCell> parts;
    if (next == Next::nodes) {
        if (opening.count > 1) parts.push_back(*this), parts.back().next = Next::patch;
        return parts;
    }
    const bool opening_differs = next == Next::opening;
    const FlatCell& whole = opening_differs ? opening : patch;
    for (FlatCell& half : whole.halves()) {
        ShadowedCell part = *this;
        part.weight *= half.size / whole.size;
        (opening_differs ? part.opening : part.patch) = std::move(half);
        parts.push_back(std::move(part));
    }
    return parts;
}

}  // namespace hanei
