#include "engine/transport/side_on_its_way.h"

#include <algorithm>
#include <cmath>

namespace hanei {

namespace {

// A room needs some ten directions to a millionth, and at reflectance 0.99 the last sixteen of forty
// do as well as all; more would cost memory: three values
// an unknown, side and direction.
constexpr std::size_t directions_held = 16;

// Mixing must leave this much less of the residual from one round of directions to the next, or
// reflections are summed one by one, which always ends.
constexpr double least_progress = 0.99;

// Relative, of a product with some thousand coefficients and of what is mixed from it.
constexpr double rounding_of_product = 1e-14;
constexpr double rounding_of_sum = 1e-15;
constexpr double rounding_of_exitance = 1e-13;

}  // namespace

std::vector<double> first_sent_by(const LightSide& side) {
    std::vector<double> sent = emitted_by(side);
    if (side.guess.empty()) return sent;
    if (side.guess_arriving.empty()) return {side.guess.begin(), side.guess.end()};
    Directions one(1);
    const Directions::Direction* guess = one.add(side.reflectance, {side.guess.begin(), side.guess.end()},
                                                 {side.guess_arriving.begin(), side.guess_arriving.end()});
    if (!guess) return sent;  // dark
    const double share = dot(sent, guess->missing);
    for (std::size_t k = 0; k < sent.size(); ++k) sent[k] -= share * guess->missing[k];
    return sent;
}

SideSolved::SideSolved(const LightSide& side, const RowSums& rows, const Comparison& comparison,
                       const BalanceLimits& limits)
    : side_(side),
      rows_(rows),
      comparison_(comparison),
      limits_(limits),
      directions_(directions_held),
      emitted_(emitted_by(side)),
      leaving_(first_sent_by(side)),
      exitance_(emitted_.size(), 0.0),
      arriving_(emitted_.size(), 0.0),
      residual_(emitted_),
      sum_(emitted_.size(), 0.0),
      low_(emitted_.size()),
      high_(emitted_.size()),
      rounding_(emitted_.size()) {
    // uniform light costs no product: the row sums are known
    mix_in(std::vector<double>(emitted_.size(), 1.0), rows.plain);
    mix_in({side.reflectance.begin(), side.reflectance.end()}, rows.reflecting);
    if (!side.guess_arriving.empty()) {
        mix_in({side.guess.begin(), side.guess.end()}, {side.guess_arriving.begin(), side.guess_arriving.end()});
    }
    look_at_residual();
}

void SideSolved::arrive(const std::vector<double>& arriving) {
    ++bounces_;
    if (one_by_one_) {
        for (std::size_t k = 0; k < exitance_.size(); ++k) {
            exitance_[k] += leaving_[k];
            arriving_[k] += arriving[k];
        }
    } else {
        mix_in(leaving_, arriving);
    }
    if (shows_bounces()) {
        for (std::size_t k = 0; k < sum_.size(); ++k) sum_[k] += arriving[k];
    }
    look_at_residual();
    choose_next(arriving);
}

void SideSolved::mix_in(std::vector<double> leaving, std::vector<double> arriving) {
    const Directions::Direction* direction =
        directions_.add(side_.reflectance, std::move(leaving), std::move(arriving));
    if (!direction) return;
    const double share = dot(residual_, direction->missing);
    for (std::size_t k = 0; k < exitance_.size(); ++k) {
        exitance_[k] += share * direction->leaving[k];
        arriving_[k] += share * direction->arriving[k];
        residual_[k] = emitted_[k] + side_.reflectance[k] * arriving_[k] - exitance_[k];
    }
}

void SideSolved::look_at_residual() {
    double brightest = 0.0;
    for (const double exitance : exitance_) brightest = std::max(brightest, std::abs(exitance));
    bool all_rounding = true;
    for (std::size_t k = 0; k < residual_.size(); ++k) {
        const double reflectance = side_.reflectance[k];
        residual_[k] = emitted_[k] + reflectance * arriving_[k] - exitance_[k];
        rounding_[k] = rounding_of_product * reflectance * brightest + rounding_of_sum * emitted_[k];
        all_rounding = all_rounding && std::abs(residual_[k]) <= rounding_[k];
    }
    comparison_.bound(residual_, rounding_, low_, high_);
    double total = 0.0, half_width = 0.0;
    for (std::size_t k = 0; k < low_.size(); ++k) {
        low_[k] = std::min(std::max(low_[k], -arriving_[k]), high_[k]);  // no light is negative
        total = std::max(total, side_.direct[k] + arriving_[k] + low_[k]);
        half_width = std::max(half_width, 0.5 * (high_[k] - low_[k]));
    }
    converged_ = half_width <= limits_.accuracy * total;
    ended_ = converged_ || all_rounding || bounces_ >= limits_.bounces;
}

void SideSolved::choose_next(const std::vector<double>& arriving) {
    if (shows_bounces() && bounces_ < limits_.first_bounces) {
        for (std::size_t k = 0; k < leaving_.size(); ++k) leaving_[k] = side_.reflectance[k] * arriving[k];
        return;
    }
    leaving_ = residual_;
    if (one_by_one_ || static_cast<std::size_t>(bounces_) % directions_held != 0) return;
    const double length = std::sqrt(dot(residual_, residual_));
    one_by_one_ = residual_before_ > 0.0 && length > least_progress * residual_before_;
    residual_before_ = length;
}

Balance SideSolved::state() const {
    const bool partial_sum = shows_bounces() && !ended_;
    Balance result;
    result.sent = exitance_;
    result.arrived = arriving_;
    result.bounces = bounces_;
    result.converged = converged_;
    result.greatest_row_sum = rows_.greatest;
    for (std::size_t k = 0; k < arriving_.size(); ++k) {
        const double middle = arriving_[k] + 0.5 * (low_[k] + high_[k]);
        const double arriving = std::max(0.0, partial_sum ? sum_[k] : middle);  // rounding may leave less than none
        const double width =
            partial_sum ? std::max(0.0, arriving_[k] + high_[k] - sum_[k]) : 0.5 * (high_[k] - low_[k]);
        const double exitance = side_.own_exitance[k] + side_.reflectance[k] * (side_.direct[k] + arriving);
        result.interreflected.push_back(arriving);
        result.exitance.push_back(exitance);
        result.exitance_half_width.push_back(
            std::min(unbounded, side_.reflectance[k] * width + rounding_of_exitance * exitance));
    }
    return result;
}

}  // namespace hanei
