#include "engine/plan/skipping.h"

#include "engine/plan/places.h"
#include "engine/scene/grid_spacing.h"

#include <algorithm>

namespace hanei {
namespace {

constexpr double most_rectangles_a_side = 8.0;

}  // namespace

double greatest(std::span<const double> values) {
    return values.empty() ? 0.0 : *std::max_element(values.begin(), values.end());
}

Skipping::Skipping(const Scene& scene, std::shared_ptr<const LightCeiling> ceiling) : ceiling_(std::move(ceiling)) {
    const auto cells = ceiling_->cells();
    const auto add = [&](const auto& place) { places_.emplace_back(place, cells); };
    const std::vector<Receiver> points = few_calculation_points(scene);
    are_points_ = !points.empty();
    for (const Receiver& point : points) add(point);
    if (are_points_) return;
    for (const CalculationPoint& point : scene.points) add(Receiver{point.position, point.normal, Vec3{0.0}});
    for (const CalculationGrid& grid : scene.grids) {
        const Vec3 area = glm::cross(grid.along, grid.across);
        if (!(grid.spacing > 0.0) || !(glm::length(area) > 0.0)) continue;
        const auto pieces = [&](const Vec3& side) {
            return static_cast<int>(std::min(most_rectangles_a_side, grid_cells(glm::length(side), grid.spacing)));
        };
        const int columns = pieces(grid.along), rows = pieces(grid.across);
        const Vec3 along = grid.along / static_cast<double>(columns), across = grid.across / static_cast<double>(rows);
        for (int row = 0; row < rows; ++row)
            for (int column = 0; column < columns; ++column)
                add(cell_of_rectangle(
                    grid.corner + along * static_cast<double>(column) + across * static_cast<double>(row), along,
                    across));
    }
    if (places_.empty())
        for (const CeilingCell& cell : cells) add(cell);
}

std::vector<double> Skipping::bounds_of(const LeavingLight& missing) const {
    std::vector<double> bounds;
    const std::vector<std::size_t> brightest = brightest_first(missing.exitance);
    for (const SeenCells& seen : places_) bounds.push_back(seen.arriving(missing, brightest));
    return bounds;
}

Skipping::Chosen Skipping::choose(std::span<const SkipCandidate> candidates, double tolerance_lux) const {
    Chosen chosen{std::vector<bool>(candidates.size(), false), {}, std::vector<double>(places_.size(), 0.0)};
    const auto skip = [&](std::size_t k, std::span<const double> bounds) {
        chosen.skipped[k] = true;
        for (std::size_t p = 0; p < bounds.size(); ++p) chosen.bound[p] += bounds[p];
        chosen.missing += candidates[k].missing;
    };
    struct Offer {
        std::size_t candidate;
        std::vector<double> bounds;
        double price;  // lx a millisecond saved
    };
    std::vector<Offer> offers;
    for (std::size_t k = 0; k < candidates.size(); ++k) {
        if (candidates[k].choice == EffectChoice::always) continue;
        std::vector<double> bounds = bounds_of(candidates[k].missing);
        if (candidates[k].choice == EffectChoice::never)
            skip(k, bounds);
        else
            offers.push_back({k, bounds, greatest(bounds) / std::max(1e-6, candidates[k].saved_ms)});
    }
    std::stable_sort(offers.begin(), offers.end(), [](const Offer& a, const Offer& b) { return a.price < b.price; });
    for (const Offer& offer : offers) {
        bool fits = tolerance_lux > 0.0;
        for (std::size_t p = 0; p < offer.bounds.size() && fits; ++p)
            fits = chosen.bound[p] + offer.bounds[p] <= tolerance_lux;
        if (fits) skip(offer.candidate, offer.bounds);
    }
    return chosen;
}

}  // namespace hanei
