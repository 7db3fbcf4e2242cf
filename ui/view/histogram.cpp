#include "ui/view/histogram.h"

#include "engine/geometry/polygon.h"
#include "ui/view/cell_field.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace hanei {
namespace {

using Samples = std::vector<LightHistogram::Sample>;

std::optional<double> part_of(const PointValue& value, LightPart part) {
    if (value.inside_solid || part == LightPart::unshadowed) return std::nullopt;
    return part == LightPart::direct           ? value.direct.value
           : part == LightPart::interreflected ? value.interreflected.value
                                               : value.total().value;
}

Samples grid_samples(const Solution& solution, ObjectId id, LightPart part) {
    Samples samples;
    const auto authored = std::find_if(solution.scene->grids.begin(), solution.scene->grids.end(),
                                       [&](const CalculationGrid& grid) { return grid.id == id; });
    if (authored == solution.scene->grids.end()) return samples;
    const double whole = glm::length(glm::cross(authored->along, authored->across));
    for (const GridResult& grid : solution.grids) {
        if (grid.grid != id) continue;
        for (const PointResult& point : grid.points)
            if (const auto lux = part_of(point.value, part))
                samples.push_back({*lux, whole / static_cast<double>(grid.points.size())});
    }
    return samples;
}

/// The quarters of every cell, each by its middle.
Samples surface_samples(const Solution& solution, LightPart part) {
    Samples samples;
    if (!has_part(solution, part)) return samples;
    for (const DisplayCell& cell : solution.display->cells) {
        const std::array<double, 4> values = corner_values(*solution.display, cell, part);
        Polygon outline;
        for (const std::uint32_t corner : cell.corner) outline.push_back(solution.display->vertices[corner].position);
        const double area = glm::length(vector_area(outline));
        if (cell.corner[3] == cell.corner[2]) {
            samples.push_back({(values[0] + values[1] + values[2]) / 3.0, area});
            continue;
        }
        for (const Vec2 at : {Vec2(0.25, 0.25), Vec2(0.75, 0.25), Vec2(0.25, 0.75), Vec2(0.75, 0.75)})
            samples.push_back({bilinear(values, at), 0.25 * area});
    }
    return samples;
}

}  // namespace

double LightHistogram::share_above(double lux) const {
    const auto first = std::lower_bound(samples.begin(), samples.end(), lux,
                                        [](const Sample& sample, double level) { return sample.lux < level; });
    double above = 0.0;
    for (auto sample = first; sample != samples.end(); ++sample) above += sample->area;
    return area > 0.0 ? above / area : 0.0;
}

LightHistogram histogram_of(const Solution& solution, ObjectId grid, const ViewOptions& look, int bins) {
    LightHistogram made;
    made.samples = grid ? grid_samples(solution, grid, look.part) : surface_samples(solution, look.part);
    if (made.samples.empty()) return made;
    std::stable_sort(made.samples.begin(), made.samples.end(),
                     [](const auto& a, const auto& b) { return a.lux < b.lux; });
    for (const LightHistogram::Sample& sample : made.samples) {
        made.area += sample.area;
        made.mean += sample.lux * sample.area;
    }
    made.mean = made.area > 0.0 ? made.mean / made.area : 0.0;
    made.least = made.samples.front().lux;
    made.greatest = made.samples.back().lux;
    if (!(made.greatest > 0.0)) return made;
    const bool linear = look.steps == ColourSteps::linear;
    constexpr double deepest = 1e-3;  // of the greatest value: what is darker stands in the first bin
    const double low = linear ? 0.0 : std::max(made.least, deepest * made.greatest);
    const double high = made.greatest > low ? made.greatest : 1.01 * low;
    for (int k = 0; k <= bins; ++k) {
        const double share = static_cast<double>(k) / bins;
        const double border = linear ? low + share * (high - low) : low * std::pow(high / low, share);
        if (k > 0) made.bins.back().high = border;
        if (k < bins) made.bins.push_back({border, border, 0.0});
    }
    for (const LightHistogram::Sample& sample : made.samples) {
        const double share = linear ? (sample.lux - low) / (high - low)
                                    : std::log(std::max(sample.lux, low) / low) / std::log(high / low);
        const int bin = std::clamp(static_cast<int>(share * bins), 0, bins - 1);
        made.bins[static_cast<std::size_t>(bin)].area += sample.area;
    }
    return made;
}

}  // namespace hanei
