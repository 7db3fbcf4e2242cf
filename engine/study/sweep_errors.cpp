#include "engine/study/sweep_errors.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <map>

namespace hanei {
namespace {

double lux_of(const PointResult& point) { return point.value.inside_solid ? -1.0 : point.value.total().value; }

struct Spread {
    double mean = 0.0, p95 = 0.0, max = 0.0;
};

Spread spread_of(std::vector<double> figures) {
    Spread spread;
    if (figures.empty()) return spread;
    std::sort(figures.begin(), figures.end());
    for (const double figure : figures) spread.mean += figure / static_cast<double>(figures.size());
    spread.p95 = figures[std::min(figures.size() - 1, figures.size() * 95 / 100)];
    spread.max = figures.back();
    return spread;
}

SweepErrors errors_of(const std::string& set, const std::vector<ComparedValue>& got,
                      const std::vector<ComparedValue>& expected, const std::vector<std::size_t>& which) {
    constexpr double boundless = 1e9;  // of a value that is no number
    double mean = 0.0;
    for (const std::size_t k : which) mean += expected[k].lux / static_cast<double>(which.size());
    std::vector<double> shares, differences;
    for (const std::size_t k : which) {
        const double of = std::max(expected[k].lux, 0.1 * mean);
        const double found = std::abs(std::max(0.0, got[k].lux) - expected[k].lux);
        const double difference = std::isfinite(got[k].lux) ? std::min(found, boundless) : boundless;
        differences.push_back(difference);
        shares.push_back(of > 0.0 ? std::min(difference / of, boundless) : 0.0);
    }
    const Spread share = spread_of(std::move(shares)), lux = spread_of(std::move(differences));
    return {set, share.mean, share.p95, share.max, lux.mean, lux.p95, lux.max};
}

}  // namespace

std::vector<ComparedValue> compared_values(const Solution& solution, const std::vector<std::string>& point_sets) {
    std::vector<ComparedValue> values;
    for (std::size_t k = 0; k < solution.points.size(); ++k)
        values.push_back({lux_of(solution.points[k]), k < point_sets.size() ? point_sets[k] : "points"});
    for (std::size_t g = 0; g < solution.grids.size(); ++g) {
        const std::string& name = solution.scene->grids[g].name;
        for (const PointResult& point : solution.grids[g].points)
            values.push_back({lux_of(point), name.empty() ? fmt::format("grid {}", g + 1) : name});
    }
    return values;
}

std::vector<SweepErrors> errors_by_set(const std::vector<ComparedValue>& got,
                                       const std::vector<ComparedValue>& expected) {
    std::vector<std::size_t> all;
    std::map<std::string, std::vector<std::size_t>> sets;
    for (std::size_t k = 0; k < expected.size(); ++k) {
        if (!(expected[k].lux >= 0.0)) continue;
        all.push_back(k);
        sets[expected[k].set].push_back(k);
    }
    std::vector<SweepErrors> errors{errors_of("all", got, expected, all)};
    if (sets.size() < 2) return errors;
    for (const auto& [set, which] : sets) errors.push_back(errors_of(set, got, expected, which));
    return errors;
}

}  // namespace hanei
