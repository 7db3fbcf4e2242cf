#include "engine/base/check.h"
#include "engine/transport/balance.h"
#include "engine/transport/series.h"

#include <algorithm>

namespace hanei {

namespace {

constexpr double rounding = 1e-13;  // of a sum over some thousand unknowns and some hundred reflections

double greatest(std::span<const double> values) {
    double found = 0.0;
    for (const double value : values) found = std::max(found, value);
    return found;
}

/// One side's series summed so far.
class SideSeries {
public:
    explicit SideSeries(const LightSide& side) : side_(side), sum_(side.direct.size(), 0.0) {
        leaving_.reserve(sum_.size());
        for (std::size_t k = 0; k < sum_.size(); ++k)
            leaving_.push_back(side.own_exitance[k] + side.reflectance[k] * side.direct[k]);
    }

    std::span<const double> leaving() const { return leaving_; }
    RowSums& rows() { return rows_; }

    void arrive(std::vector<double> arriving) {
        before_ = std::move(last_);
        last_ = std::move(arriving);
        for (std::size_t k = 0; k < sum_.size(); ++k) {
            sum_[k] += last_[k];
            leaving_[k] = side_.reflectance[k] * last_[k];
        }
        ++bounces_;
    }

    Balance state(const BalanceLimits& limits, bool& ends) const {
        TailBounds tail = tail_by_row_sums(rows_, greatest(leaving_));
        if (bounces_ >= 2) tail.narrow(ratios_of(last_, before_), last_);
        Balance result;
        result.bounces = bounces_;
        result.greatest_row_sum = rows_.greatest;
        double total = 0.0;
        for (std::size_t k = 0; k < sum_.size(); ++k) total = std::max(total, side_.direct[k] + sum_[k] + tail.low(k));
        result.converged = tail.greatest_half_width() <= limits.accuracy * total;
        const double last = greatest(bounces_ == 0 ? leaving_ : last_);
        ends = result.converged || bounces_ >= limits.bounces || tail.diverges() || last > too_large;
        write(tail, result.converged || (!ends && tail.is_bracket()), result);
        return result;
    }

private:
    void write(const TailBounds& tail, bool with_tail, Balance& result) const {
        for (std::size_t k = 0; k < sum_.size(); ++k) {
            const double low = tail.low(k);
            const double high = tail.high(k);
            const double arriving = sum_[k] + (with_tail ? 0.5 * (low + high) : 0.0);
            const double exitance = side_.own_exitance[k] + side_.reflectance[k] * (side_.direct[k] + arriving);
            const double width = with_tail ? 0.5 * (high - low) : high;
            result.interreflected.push_back(arriving);
            result.exitance.push_back(exitance);
            result.exitance_half_width.push_back(
                std::min(unbounded, side_.reflectance[k] * width + rounding * exitance));
        }
    }

    LightSide side_;
    RowSums rows_;
    std::vector<double> last_, before_, sum_, leaving_;
    int bounces_ = 0;
};

/// Products of several columns at once.
std::optional<std::vector<std::vector<double>>> exchanged(const Exchange& exchange, std::size_t unknowns,
                                                          const std::vector<std::span<const double>>& columns) {
    const std::size_t sides = columns.size();
    std::vector<double> leaving(unknowns * sides), arriving(unknowns * sides);
    for (std::size_t s = 0; s < sides; ++s) {
        for (std::size_t k = 0; k < unknowns; ++k) leaving[k * sides + s] = columns[s][k];
    }
    if (!exchange(leaving, arriving, sides)) return std::nullopt;
    std::vector<std::vector<double>> result(sides);
    for (std::size_t s = 0; s < sides; ++s) {
        result[s].reserve(unknowns);
        for (std::size_t k = 0; k < unknowns; ++k) result[s].push_back(arriving[k * sides + s]);
    }
    return result;
}

}  // namespace

Exchange exchange_by(const DenseRows& factors, const Visibility* visibility, const Work& work) {
    return
        [&factors, visibility, work](std::span<const double> leaving, std::span<double> arriving, std::size_t sides) {
            return multiply(factors, visibility, leaving, arriving, sides, work);
        };
}

std::optional<std::vector<Balance>> balance(const Exchange& exchange, std::size_t unknowns,
                                            std::span<const LightSide> sides, const BalanceLimits& limits,
                                            const Work& work,
                                            const std::function<bool(std::span<const Balance>)>& on_bounce) {
    std::vector<SideSeries> series;
    std::vector<double> ones(unknowns, 1.0);
    std::vector<std::span<const double>> columns = {ones};
    for (const LightSide& side : sides) {
        HANEI_CHECK(side.reflectance.size() == unknowns && side.direct.size() == unknowns);
        HANEI_CHECK(side.own_exitance.size() == unknowns);
        HANEI_CHECK(side.guess.empty() || side.guess.size() == unknowns);
        series.emplace_back(side);
        columns.push_back(side.reflectance);
    }
    int products = 1;
    const auto sums = exchanged(exchange, unknowns, columns);
    if (!sums) return std::nullopt;
    for (std::size_t s = 0; s < sides.size(); ++s) {
        RowSums& rows = series[s].rows();
        rows = {(*sums)[0], (*sums)[s + 1], greatest((*sums)[0]), greatest((*sums)[s + 1])};
    }
    std::vector<Balance> states(sides.size());
    std::vector<bool> ended(sides.size(), false);
    while (true) {
        columns.clear();
        for (std::size_t s = 0; s < sides.size(); ++s) {
            if (ended[s]) continue;
            bool ends = false;
            states[s] = series[s].state(limits, ends);
            states[s].products = products;
            ended[s] = ends;
            if (!ends) columns.push_back(series[s].leaving());
        }
        if (products > 1 && on_bounce && !on_bounce(states)) return std::nullopt;
        if (columns.empty()) return states;
        if (work.stop.stop_requested()) return std::nullopt;
        auto arriving = exchanged(exchange, unknowns, columns);
        if (!arriving) return std::nullopt;
        ++products;
        auto next = arriving->begin();
        for (std::size_t s = 0; s < sides.size(); ++s) {
            if (!ended[s]) series[s].arrive(std::move(*next++));
        }
    }
}

}  // namespace hanei
