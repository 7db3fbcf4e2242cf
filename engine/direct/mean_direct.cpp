#include "engine/base/tiles.h"
#include "engine/direct/direct.h"
#include "engine/direct/facing_parts.h"
#include "engine/direct/mean_cell.h"
#include "engine/direct/shadow_proof.h"
#include "engine/direct/sight_hull.h"
#include "engine/geometry/polygon.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

namespace hanei {

namespace {

constexpr double finest_share = 2e-4;  // of a mean: what is asked for at most
constexpr double of_allowed = 0.2;     // less is not claimed: nodes can miss a rim of that
constexpr std::size_t most_cuts = 31;  // of a patch in free light: 128 nodes
constexpr std::size_t most_in_shadow = 31;

/// Cuts the cell of the greatest error until what all may be off by together is allowed. Errors of cells
/// hardly depend on each other; a tenth is taken to.
template <class Cell>
Estimate refined(std::vector<Cell>& cells, const LightOnPatch& light, const Accuracy& allowed, std::size_t most) {
    const auto less = [](const Cell& a, const Cell& b) { return a.mean.error < b.mean.error; };
    for (std::size_t cuts = 0;; ++cuts) {
        double value = 0.0, error = 0.0, squares = 0.0;
        for (const Cell& cell : cells) {
            value += cell.mean.value;
            error += cell.mean.error;
            squares += cell.mean.error * cell.mean.error;
        }
        const double together = std::max(0.1 * error + 0.9 * std::sqrt(squares), of_allowed * allowed.allowed(value));
        if (cuts == most || together <= allowed.allowed(value)) return {value, together};
        const auto worst = std::ranges::max_element(cells, less);
        std::vector<Cell> halves = worst->halves();
        if (halves.empty()) return {value, together};
        for (Cell& half : halves) half.measure(light);
        *worst = std::move(halves.front());
        if (halves.size() > 1) cells.push_back(std::move(halves.back()));
    }
}

/// Where a narrow beam meets a plane.
struct BeamSpot {
    Vec3 middle;
    double half_width = 0.0;  ///< m, across the beam
    double reach = 0.0;       ///< m: what lies farther off hardly matters

    static std::optional<BeamSpot> on(const Plane& plane, const NarrowBeam& beam) {
        constexpr double reach = 4.0;  // half widths
        const double falling = -glm::dot(beam.axis, plane.normal);
        if (!(falling > 1e-3) || !(plane.height(beam.from) > 0.0)) return std::nullopt;
        const double distance = plane.height(beam.from) / falling;
        const double half_width = distance * std::tan(beam.half_angle);
        return BeamSpot{beam.from + distance * beam.axis, half_width, reach * half_width / falling};
    }
};

template <class Cell>
void add_part(std::vector<Cell>& cells, const Cell& of, Polygon corners, const LightOnPatch& light) {
    Cell part = of;
    part.patch = FlatCell(std::move(corners));
    if (part.patch.count == 0) return;
    part.weight *= part.patch.size / of.patch.size;
    part.measure(light);
    cells.push_back(std::move(part));
}

/// What lies about the spot, and the parts beside it.
template <class Cell>
std::pair<std::vector<Cell>, std::vector<Cell>> cut_around(const Cell& cell, const BeamSpot& spot,
                                                           const LightOnPatch& light) {
    std::vector<Cell> about, beside;
    Polygon rest = cell.patch.corners;
    const Vec3 x = glm::normalize(cell.patch.along), y = glm::cross(light.normal, x);
    for (const Vec3& way : {x, -x, y, -y}) {
        const Vec3 border = spot.middle + spot.reach * way;
        add_part(beside, cell, clipped(rest, {border, way}, 0.0), light);
        rest = clipped(rest, {border, -way}, 0.0);
        if (rest.size() < 3) return {std::move(about), std::move(beside)};
    }
    add_part(about, cell, std::move(rest), light);
    return {std::move(about), std::move(beside)};
}

/// Cuts cells that a narrow beam meets until their nodes notice it: all of them may lie beside it.
template <class Cell>
void cut_at_beam(std::vector<Cell>& cells, const LightOnPatch& light) {
    constexpr double fine = 1.5;  // half widths of the beam: so wide a cell has nodes in it
    constexpr std::size_t most = 1000;
    const std::optional<NarrowBeam> beam = light.emitter.narrow_beam();
    if (!beam || cells.empty()) return;
    const auto spot = BeamSpot::on({cells.front().patch.centre, light.normal}, *beam);
    if (!spot) return;
    std::vector<Cell> cut;
    for (const Cell& whole : cells) {
        if (whole.patch.count == 0) continue;
        auto [about, beside] = cut_around(whole, *spot, light);
        std::ranges::move(beside, std::back_inserter(cut));
        for (std::size_t k = 0; k < about.size() && about.size() < most;) {
            const bool misses = diameter(about[k].patch.corners) > fine * spot->half_width;
            std::vector<Cell> halves = misses ? about[k].halves() : std::vector<Cell>{};
            if (halves.empty()) {
                ++k;
                continue;
            }
            for (Cell& half : halves) half.measure(light);
            about[k] = std::move(halves.front());
            if (halves.size() > 1) about.push_back(std::move(halves.back()));
        }
        std::ranges::move(about, std::back_inserter(cut));
    }
    if (!cut.empty()) cells = std::move(cut);
}

/// A luminous piece that gives light to a patch, and what stands between.
struct Shining {
    std::size_t piece;
    FacingParts facing;
    bool shadowed;
};

class PatchSight {
public:
    PatchSight(const ReceivingPolygon& polygon, const Emitter& emitter, const OccluderSet* occluders)
        : polygon_(polygon), emitter_(emitter), occluders_(occluders) {
        bodies.clear();
        for (std::size_t k = 0; k < emitter.pieces().size(); ++k) add(k);
        if (shining.size() < 2) return;
        std::ranges::sort(bodies);
        bodies.erase(std::unique(bodies.begin(), bodies.end()), bodies.end());
    }

    std::vector<Shining> shining;
    thread_local static std::vector<BodyIndex> bodies;  ///< between the patch and any of these

private:
    void add(std::size_t piece) {
        std::optional<FacingParts> facing = facing_parts(polygon_, emitter_.pieces()[piece]);
        if (!facing) return;
        thread_local std::vector<BodyIndex> found;
        found.clear();
        if (occluders_) occluders_->between(facing->patch, facing->opening, found);
        const std::uint32_t own = emitter_.luminaire().value;
        std::erase_if(found, [&](BodyIndex body) { return occluders_->bodies()[body].owner == own; });
        if (!found.empty()) {
            if (is_hidden_by_one({facing->patch, facing->opening, *occluders_, found})) return;
            SightHull hull(facing->patch, facing->opening);
            const double touching = occluders_->same_place();
            std::erase_if(found, [&](BodyIndex body) {
                return hull.is_soon_clear_of(occluders_->shape(body), occluders_->bodies()[body].vertices, touching);
            });
        }
        bodies.insert(bodies.end(), found.begin(), found.end());
        shining.push_back({piece, std::move(*facing), !found.empty()});
    }

    const ReceivingPolygon& polygon_;
    const Emitter& emitter_;
    const OccluderSet* occluders_;
};

thread_local std::vector<BodyIndex> PatchSight::bodies;

Estimate mean_on(const ReceivingPolygon& polygon, const Emitter& emitter, const OccluderSet* occluders,
                 const Accuracy& accuracy) {
    if (polygon.outline.size() < 3) return {};
    const PatchSight sight(polygon, emitter, occluders);
    if (sight.shining.empty()) return {};
    FlatCell whole(Polygon(polygon.outline.begin(), polygon.outline.end()));
    if (whole.count == 0) return {};
    const LightOnPatch light{emitter, occluders, sight.bodies, polygon.normal, accuracy};
    const Accuracy allowed{std::max(accuracy.share, finest_share), accuracy.floor};
    if (!emitter.shines_from_places() || (sight.bodies.empty() && emitter.is_exact())) {
        std::vector<ReceivingCell> cells;
        if (sight.shining.size() == 1) {
            FlatCell lit(sight.shining[0].facing.patch);
            const double share = lit.size / whole.size;
            cells.push_back({std::move(lit), share, {}});
        } else {
            cells.push_back({std::move(whole), 1.0, {}});
        }
        cells[0].measure(light);
        cut_at_beam(cells, light);
        return refined(cells, light, allowed, most_cuts);
    }
    std::vector<ShadowedCell> cells;
    for (const Shining& shining : sight.shining) {
        FlatCell patch(shining.facing.patch), opening(shining.facing.opening);
        const double whole_piece = FlatCell(emitter.pieces()[shining.piece].corners).size;
        const double weight = patch.size / whole.size * (opening.size / whole_piece);
        cells.push_back({std::move(patch), std::move(opening), shining.piece, weight, {}});
        cells.back().measure(light);
    }
    cut_at_beam(cells, light);
    return refined(cells, light, allowed, most_in_shadow);
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
