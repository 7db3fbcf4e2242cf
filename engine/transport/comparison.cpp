#include "engine/transport/comparison.h"

#include "engine/transport/series.h"

#include <algorithm>
#include <limits>

namespace hanei {

namespace {

// Row sums are known to the rounding of floats: what is lost by less than this may be lost by nothing.
constexpr double least_loss = 1e-6;

// Rows of a closed room that were kept in few bits seem to gain light, by less than this; the paper's
// next to an edge gain many times as much.
constexpr double most_gain = 0.02;

bool all_above(std::span<const double> values, double limit) {
    return std::all_of(values.begin(), values.end(), [limit](double value) { return value > limit; });
}

}  // namespace

Comparison::Comparison(std::span<const double> reflectance, std::span<const double> plain,
                       std::span<const double> reflecting)
    : reflectance_(reflectance) {
    Uniform ones{{plain.begin(), plain.end()}, {}};
    Uniform of_reflectance{{reflecting.begin(), reflecting.end()}, {}};
    bool all_lose = true;
    for (std::size_t k = 0; k < plain.size(); ++k) {
        growing_.push_back(reflectance[k] * plain[k]);
        ones.lost.push_back(1.0 - growing_.back());
        of_reflectance.lost.push_back(reflectance[k] * (1.0 - reflecting[k]));
        all_lose = all_lose && 1.0 - reflecting[k] > least_loss;
    }
    const bool none_gains = all_above(ones.lost, -most_gain);
    if (all_above(ones.lost, least_loss)) serving_.push_back(std::move(ones));
    if (all_lose) serving_.push_back(std::move(of_reflectance));
    if (dies_out() || !none_gains) growing_.clear();
    arriving_.assign(plain.begin(), plain.end());
}

void Comparison::grow(std::span<const double> arriving) {
    std::vector<double> lost;
    for (std::size_t k = 0; k < growing_.size(); ++k) {
        arriving_[k] += arriving[k];
        growing_[k] = reflectance_[k] * arriving[k];
        lost.push_back(1.0 - growing_[k]);
    }
    if (!all_above(lost, least_loss)) return;
    serving_.push_back({std::move(arriving_), std::move(lost)});
    growing_.clear();
}

void Comparison::narrow(const Uniform& light, std::span<const double> residual, std::span<const double> rounding,
                        std::span<double> low, std::span<double> high) {
    double least = std::numeric_limits<double>::infinity();
    double greatest = -least;
    for (std::size_t k = 0; k < residual.size(); ++k) {
        const double below = residual[k] - rounding[k];
        const double above = residual[k] + rounding[k];
        if (light.lost[k] <= 0.0) {  // black, and w is its reflectance
            if (below < 0.0 || above > 0.0) return;
            continue;
        }
        least = std::min(least, below / light.lost[k]);
        greatest = std::max(greatest, above / light.lost[k]);
    }
    if (least > greatest) least = greatest = 0.0;  // nothing reflects, and nothing is missing
    for (std::size_t k = 0; k < residual.size(); ++k) {
        low[k] = std::max(low[k], least * light.arriving[k]);
        high[k] = std::min(high[k], greatest * light.arriving[k]);
    }
}

void Comparison::bound(std::span<const double> residual, std::span<const double> rounding, std::span<double> low,
                       std::span<double> high) const {
    std::fill(low.begin(), low.end(), -unbounded);
    std::fill(high.begin(), high.end(), unbounded);
    for (const Uniform& light : serving_) narrow(light, residual, rounding, low, high);
    for (std::size_t k = 0; k < residual.size(); ++k)
        high[k] = std::max(high[k], low[k]);  // one number but for rounding
}

}  // namespace hanei
