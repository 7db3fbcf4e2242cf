#include "engine/transport/directions.h"

#include "engine/transport/sums.h"

#include <cmath>

namespace hanei {

namespace {

// What is left of a direction without the others, when that is rounding alone.
constexpr double no_direction = 1e-12;

void add_multiple(std::vector<double>& to, double times, const std::vector<double>& of) {
    for (std::size_t k = 0; k < to.size(); ++k) to[k] += times * of[k];
}

void scale(std::vector<double>& values, double by) {
    for (double& value : values) value *= by;
}

}  // namespace

double dot(std::span<const double> a, std::span<const double> b) {
    return sum_of(a.size(), [=](std::size_t k) { return a[k] * b[k]; });
}

const Directions::Direction* Directions::add(std::span<const double> reflectance, std::vector<double> leaving,
                                             std::vector<double> arriving) {
    Direction fresh{std::move(leaving), std::move(arriving), {}};
    fresh.missing.reserve(fresh.leaving.size());
    for (std::size_t k = 0; k < fresh.leaving.size(); ++k)
        fresh.missing.push_back(fresh.leaving[k] - reflectance[k] * fresh.arriving[k]);
    const double whole = std::sqrt(dot(fresh.missing, fresh.missing));
    for (int pass = 0; pass < 2; ++pass) {  // twice: once leaves what rounding made of nearly parallel ones
        for (const Direction& other : held_) {
            const double shared = dot(fresh.missing, other.missing);
            add_multiple(fresh.leaving, -shared, other.leaving);
            add_multiple(fresh.arriving, -shared, other.arriving);
            add_multiple(fresh.missing, -shared, other.missing);
        }
    }
    const double length = std::sqrt(dot(fresh.missing, fresh.missing));
    if (!(length > no_direction * whole) || !std::isfinite(length)) return nullptr;
    scale(fresh.leaving, 1.0 / length);
    scale(fresh.arriving, 1.0 / length);
    scale(fresh.missing, 1.0 / length);
    if (held_.size() < most_) return &held_.emplace_back(std::move(fresh));
    Direction& place = held_[oldest_];
    oldest_ = (oldest_ + 1) % most_;
    return &(place = std::move(fresh));
}

}  // namespace hanei
