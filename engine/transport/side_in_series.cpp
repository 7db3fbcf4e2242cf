#include "engine/transport/side_on_its_way.h"

#include <algorithm>

namespace hanei {

namespace {

constexpr double rounding = 1e-13;  // of a sum over some thousand unknowns and some hundred reflections

double greatest(std::span<const double> values) {
    double found = 0.0;
    for (const double value : values) found = std::max(found, value);
    return found;
}

}  // namespace

std::vector<double> emitted_by(const LightSide& side) {
    std::vector<double> emitted;
    emitted.reserve(side.direct.size());
    for (std::size_t k = 0; k < side.direct.size(); ++k)
        emitted.push_back(side.own_exitance[k] + side.reflectance[k] * side.direct[k]);
    return emitted;
}

SideInSeries::SideInSeries(const LightSide& side, RowSums rows, const BalanceLimits& limits)
    : side_(side), rows_(std::move(rows)), limits_(limits), sum_(side.direct.size(), 0.0), leaving_(emitted_by(side)) {
    look_at_tail();
}

void SideInSeries::arrive(const std::vector<double>& arriving) {
    before_ = std::move(last_);
    last_ = arriving;
    for (std::size_t k = 0; k < sum_.size(); ++k) {
        sum_[k] += last_[k];
        leaving_[k] = side_.reflectance[k] * last_[k];
    }
    ++bounces_;
    look_at_tail();
}

void SideInSeries::look_at_tail() {
    tail_ = tail_by_row_sums(rows_, greatest(leaving_));
    if (bounces_ >= 2) tail_.narrow(ratios_of(last_, before_), last_);
    double total = 0.0;
    for (std::size_t k = 0; k < sum_.size(); ++k) total = std::max(total, side_.direct[k] + sum_[k] + tail_.low(k));
    converged_ = tail_.greatest_half_width() <= limits_.accuracy * total;
    const double last = greatest(bounces_ == 0 ? leaving_ : last_);
    ended_ = converged_ || bounces_ >= limits_.bounces || tail_.diverges() || last > too_large;
}

Balance SideInSeries::state() const {
    // the middle of the bracket, once it is closer than nothing; the partial sum where that is asked for
    const bool with_tail = converged_ || (!ended_ && tail_.is_bracket());
    Balance result;
    result.bounces = bounces_;
    result.converged = converged_;
    result.greatest_row_sum = rows_.greatest;
    for (std::size_t k = 0; k < sum_.size(); ++k) {
        const double low = tail_.low(k);
        const double high = tail_.high(k);
        const double arriving = sum_[k] + (with_tail ? 0.5 * (low + high) : 0.0);
        const double exitance = side_.own_exitance[k] + side_.reflectance[k] * (side_.direct[k] + arriving);
        const double width = with_tail ? 0.5 * (high - low) : high;
        result.interreflected.push_back(arriving);
        result.exitance.push_back(exitance);
        result.exitance_half_width.push_back(std::min(unbounded, side_.reflectance[k] * width + rounding * exitance));
    }
    return result;
}

}  // namespace hanei
