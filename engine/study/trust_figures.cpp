#include "engine/study/trust.h"

#include <algorithm>
#include <cmath>
#include <cstring>

namespace hanei {
namespace {

constexpr double rounding_of_rows = 3e-6;  // factor_rows.h: what stored rows of a closed room hold
constexpr double rounding = 1e-9;          // of sums over patches
constexpr double outside_bars = 0.05;      // of 100 error bars 95 hold
constexpr double limit_of_ratios = 1.0;    // a difference against what the error bars allow

std::vector<const PointValue*> values_at_points(const Solution& solution) {
    std::vector<const PointValue*> values;
    for (const PointResult& point : solution.points) values.push_back(&point.value);
    for (const GridResult& grid : solution.grids)
        for (const PointResult& point : grid.points) values.push_back(&point.value);
    return values;
}

std::vector<Vec3> places_of_points(const Solution& solution) {
    std::vector<Vec3> places;
    for (const PointResult& point : solution.points) places.push_back(point.position);
    for (const GridResult& grid : solution.grids)
        for (const PointResult& point : grid.points) places.push_back(point.position);
    return places;
}

std::vector<double> figures_in(const Solution& solution) {
    std::vector<double> figures;
    for (const PointValue* value : values_at_points(solution))
        figures.insert(figures.end(), {value->direct.value, value->interreflected.value, value->error.total()});
    for (const auto* list : {&solution.patch_direct, &solution.patch_interreflected, &solution.exitance})
        figures.insert(figures.end(), list->begin(), list->end());
    return figures;
}

bool same_patches(const Solution& a, const Solution& b) {
    const auto same = [](const Patch& x, const Patch& y) { return x.face == y.face && x.outline == y.outline; };
    return std::equal(a.mesh->patches.begin(), a.mesh->patches.end(), b.mesh->patches.begin(), b.mesh->patches.end(),
                      same);
}

/// Of solutions with the same patches only scaling, iterating and sampling may differ.
double allowed_in(const PointValue& value, const Solution& solution, bool patches_are_the_same) {
    const ErrorBar& bar = value.error;
    const double mesh =
        patches_are_the_same ? std::min(bar.mesh, solution.reflected_error * value.interreflected.value) : bar.mesh;
    // a fixed number of reflections is the same sum for the whole and its parts
    return (solution.converged ? bar.iteration : 0.0) + mesh + bar.skipped + bar.sampling;
}

double share_of(std::size_t part, std::size_t all) {
    return all > 0 ? static_cast<double>(part) / static_cast<double>(all) : 0.0;
}

/// An error bar as long as the value promises nothing, and allows nothing.
double promised(double error, double value) { return error < value || value == 0.0 ? error : 0.0; }

}  // namespace

TrustFigure DirectTrust::figure() const {
    return {open ? std::max(0.0, -missing()) : std::abs(missing()), error + rounding * emitted};
}

double EnergyTrust::explained() const {
    return converged ? std::clamp(under_way, -iteration_bound, iteration_bound) : std::max(0.0, under_way);
}

double EnergyTrust::unexplained() const { return energy.imbalance() - direct_missing - explained(); }

TrustFigure EnergyTrust::figure() const {
    return {std::abs(unexplained()), promised(error, received) + direct_error + rounding * energy.emitted, asked};
}

double ReciprocityTrust::Pair::ratio() const {
    const double apart = std::abs(there - back), allowed = error + rounding * (there + back);
    return allowed > 0.0 ? apart / allowed : apart > 0.0 ? HUGE_VAL : 0.0;
}

const ReciprocityTrust::Pair* ReciprocityTrust::worst() const {
    const auto less = [](const Pair& a, const Pair& b) { return a.ratio() < b.ratio(); };
    return pairs.empty() ? nullptr : &*std::max_element(pairs.begin(), pairs.end(), less);
}

std::size_t ReciprocityTrust::within() const {
    return static_cast<std::size_t>(
        std::count_if(pairs.begin(), pairs.end(), [](const Pair& pair) { return pair.ratio() <= limit_of_ratios; }));
}

TrustFigure ReciprocityTrust::figure() const {
    return {share_of(pairs.size() - within(), pairs.size()), outside_bars, asked && !pairs.empty()};
}

TrustFigure ClosureTrust::figure() const {
    const bool possible = greatest_seen <= 1.0 + rounding_of_rows && rays_agree();
    return {possible ? misplaced : HUGE_VAL, promised(error_share, 1.0) + rounding_of_rows, asked};
}

TrustFigure AdditivityTrust::figure() const { return {share_of(points - within, points), outside_bars, asked()}; }

bool TrustReport::holds() const {
    const std::array figures{direct.figure(),  energy.figure(),     reciprocity.figure(),
                             closure.figure(), additivity.figure(), threads.figure()};
    return std::none_of(figures.begin(), figures.end(),
                        [](const TrustFigure& figure) { return figure.state() == TrustState::fails; });
}

AdditivityTrust sum_of_parts(const Solution& whole, const Solution& odd, const Solution& even) {
    AdditivityTrust trust;
    trust.same_patches = same_patches(whole, odd) && same_patches(whole, even);
    const std::array solutions{&whole, &odd, &even};
    const std::array values{values_at_points(whole), values_at_points(odd), values_at_points(even)};
    const std::vector<Vec3> places = places_of_points(whole);
    for (std::size_t k = 0; k < places.size(); ++k) {
        if (values[0][k]->inside_solid) continue;
        const double all = values[0][k]->total().value;
        const double apart = std::abs(values[1][k]->total().value + values[2][k]->total().value - all);
        double allowed = rounding * all;
        for (std::size_t s = 0; s < solutions.size(); ++s)
            allowed += allowed_in(*values[s][k], *solutions[s], trust.same_patches);
        const double ratio = allowed > 0.0 ? apart / allowed : apart > 0.0 ? HUGE_VAL : 0.0;
        ++trust.points;
        if (ratio <= limit_of_ratios) ++trust.within;  // what is no number is not within
        if (trust.points > 1 && !(ratio > trust.worst_ratio)) continue;
        trust.worst_ratio = ratio;
        trust.worst_apart = apart;
        trust.worst_allowed = allowed;
        trust.worst_value = all;
        trust.worst_place = places[k];
    }
    return trust;
}

ThreadsTrust same_bits(const Solution& one, const Solution& other) {
    const std::vector<double> a = figures_in(one), b = figures_in(other);
    ThreadsTrust trust;
    trust.values = std::max(a.size(), b.size());
    trust.others = trust.values - std::min(a.size(), b.size());
    for (std::size_t k = 0; k < std::min(a.size(), b.size()); ++k)
        trust.others += std::memcmp(&a[k], &b[k], sizeof(double)) != 0 ? 1 : 0;
    return trust;
}

}  // namespace hanei
