#include "engine/transport/comparison.h"

#include "engine/transport/series.h"

#include <algorithm>
#include <limits>

namespace hanei {

namespace {

// Row sums are known to the rounding of floats: what is lost by less than this may be lost by nothing.
constexpr double least_loss = 1e-6;

}  // namespace

Comparison::Comparison(std::span<const double> reflectance, std::span<const double> plain,
                       std::span<const double> reflecting)
    : reflectance_(reflectance), plain_(plain), reflecting_(reflecting) {
    for (std::size_t k = 0; k < plain.size(); ++k) {
        by_ones_ = by_ones_ && 1.0 - reflectance[k] * plain[k] > least_loss;
        by_reflectance_ = by_reflectance_ && 1.0 - reflecting[k] > least_loss;
    }
}

double Comparison::lost(bool ones, std::size_t k) const {
    return ones ? 1.0 - reflectance_[k] * plain_[k] : reflectance_[k] * (1.0 - reflecting_[k]);
}

void Comparison::narrow(bool ones, std::span<const double> residual, std::span<const double> rounding,
                        std::span<double> low, std::span<double> high) const {
    double least = std::numeric_limits<double>::infinity();
    double greatest = -least;
    for (std::size_t k = 0; k < residual.size(); ++k) {
        const double loss = lost(ones, k);
        const double below = residual[k] - rounding[k];
        const double above = residual[k] + rounding[k];
        if (loss <= 0.0) {  // black, and w is its reflectance
            if (below < 0.0 || above > 0.0) return;
            continue;
        }
        least = std::min(least, below / loss);
        greatest = std::max(greatest, above / loss);
    }
    if (least > greatest) least = greatest = 0.0;  // nothing reflects, and nothing is missing
    const std::span<const double> arriving = ones ? plain_ : reflecting_;
    for (std::size_t k = 0; k < residual.size(); ++k) {
        low[k] = std::max(low[k], least * arriving[k]);
        high[k] = std::min(high[k], greatest * arriving[k]);
    }
}

void Comparison::bound(std::span<const double> residual, std::span<const double> rounding, std::span<double> low,
                       std::span<double> high) const {
    std::fill(low.begin(), low.end(), -unbounded);
    std::fill(high.begin(), high.end(), unbounded);
    if (by_ones_) narrow(true, residual, rounding, low, high);
    if (by_reflectance_) narrow(false, residual, rounding, low, high);
    for (std::size_t k = 0; k < residual.size(); ++k)
        high[k] = std::max(high[k], low[k]);  // one number but for rounding
}

}  // namespace hanei
