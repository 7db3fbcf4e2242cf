#include "engine/transport/balance.h"

#include "engine/base/check.h"
#include "engine/transport/series.h"

#include <algorithm>
#include <cmath>

namespace hanei {

namespace {

double greatest(std::span<const double> values) {
    double found = 0.0;
    for (const double value : values) found = std::max(found, value);
    return found;
}

/// The series summed so far: what arrives after each reflection, and the sum.
class Series {
public:
    explicit Series(const BalanceInput& input)
        : input_(input),
          last_(input.direct.size()),
          before_(input.direct.size()),
          sum_(input.direct.size(), 0.0),
          leaving_(input.direct.size()) {
        for (std::size_t k = 0; k < leaving_.size(); ++k) {
            leaving_[k] = input.own_exitance[k] + input.reflectance[k] * input.direct[k];
        }
    }

    /// One reflection more. False when stopped.
    bool reflect(const Work& work) {
        before_.swap(last_);
        if (!multiply(*input_.factors, input_.visibility, leaving_, last_, work)) return false;
        for (std::size_t k = 0; k < last_.size(); ++k) {
            sum_[k] += last_[k];
            leaving_[k] = input_.reflectance[k] * last_[k];
        }
        ++bounces_;
        return true;
    }

    int bounces() const { return bounces_; }
    double greatest_last() const { return greatest(bounces_ == 0 ? std::span<const double>(leaving_) : last_); }

    /// What is still to come lies within these, for every unknown.
    TailBounds tail(const RowSums& rows) const {
        TailBounds bounds = tail_by_row_sums(rows, greatest(leaving_));
        if (bounces_ >= 2) bounds.narrow(ratios_of(last_, before_), last_);
        return bounds;
    }

    /// The greatest total illuminance, of what is certain to arrive.
    double greatest_total(const TailBounds& tail) const {
        double found = 0.0;
        for (std::size_t k = 0; k < sum_.size(); ++k) found = std::max(found, input_.direct[k] + sum_[k] + tail.low(k));
        return found;
    }

    /// The state with the tail put in: its middle, or nothing of it.
    Balance state(const TailBounds& tail, bool with_tail) const {
        Balance result;
        result.bounces = bounces_;
        const std::size_t count = sum_.size();
        result.interreflected.resize(count);
        result.exitance.resize(count);
        result.exitance_half_width.resize(count);
        for (std::size_t k = 0; k < count; ++k) {
            const double low = tail.low(k);
            const double high = tail.high(k);
            const double reflectance = input_.reflectance[k];
            const double arriving = sum_[k] + (with_tail ? 0.5 * (low + high) : 0.0);
            result.interreflected[k] = arriving;
            result.exitance[k] = input_.own_exitance[k] + reflectance * (input_.direct[k] + arriving);
            const double width = with_tail ? 0.5 * (high - low) : high;
            result.exitance_half_width[k] = std::min(unbounded, reflectance * width + rounding * result.exitance[k]);
        }
        return result;
    }

private:
    static constexpr double rounding = 1e-13;  // of a sum over some thousand unknowns and some hundred reflections

    BalanceInput input_;
    std::vector<double> last_, before_, sum_, leaving_;
    int bounces_ = 0;
};

}  // namespace

std::optional<Balance> balance(const BalanceInput& input, const BalanceLimits& limits, const Work& work,
                               const std::function<bool(const Balance&)>& on_bounce) {
    const std::size_t count = input.direct.size();
    HANEI_CHECK(input.factors && input.factors->rows == count && input.factors->columns == count);
    HANEI_CHECK(input.reflectance.size() == count && input.own_exitance.size() == count);

    const auto rows = row_sums(*input.factors, input.visibility, input.reflectance, work);
    if (!rows) return std::nullopt;
    Series series(input);
    while (true) {
        const TailBounds tail = series.tail(*rows);
        // the middle of the bracket tells whether it is close enough; what the row sums alone bound
        // has no middle worth telling until then
        Balance state = series.state(tail, true);
        state.converged = tail.greatest_half_width() <= limits.accuracy * series.greatest_total(tail);
        const bool ends = state.converged || series.bounces() >= limits.bounces || tail.diverges() ||
                          series.greatest_last() > too_large;
        if (!state.converged && (ends || !tail.is_bracket())) state = series.state(tail, false);
        state.greatest_row_sum = rows->greatest;
        if (series.bounces() > 0 && on_bounce && !on_bounce(state)) return std::nullopt;
        if (ends) return state;
        if (!series.reflect(work)) return std::nullopt;
    }
}

std::vector<double> gather(const DenseRows& factors, const Visibility* visibility, std::span<const double> exitance,
                           const Work& work) {
    std::vector<double> arriving(factors.rows);
    if (!multiply(factors, visibility, exitance, arriving, work)) arriving.clear();
    return arriving;
}

std::vector<double> patch_exitance(const Mesh& mesh, std::span<const double> vertex_exitance) {
    std::vector<double> exitance;
    exitance.reserve(mesh.patches.size());
    for (const Patch& patch : mesh.patches) {
        double sum = 0.0;
        for (const VertexId corner : patch.corners) sum += vertex_exitance[static_cast<std::size_t>(corner)];
        exitance.push_back(sum / static_cast<double>(patch.corners.size()));
    }
    return exitance;
}

}  // namespace hanei
