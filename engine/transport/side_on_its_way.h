/// One side of light between two products with the rows.
#pragma once

#include "engine/transport/balance.h"
#include "engine/transport/comparison.h"
#include "engine/transport/directions.h"
#include "engine/transport/series.h"

#include <memory>
#include <vector>

namespace hanei {

class SideOnItsWay {
public:
    virtual ~SideOnItsWay() = default;
    virtual bool ended() const = 0;
    virtual std::span<const double> leaving() const = 0;           ///< to be sent through the rows next
    virtual void arrive(const std::vector<double>& arriving) = 0;  ///< and what came of it
    virtual Balance state() const = 0;
};

/// lm/m2 that leaves before anything was reflected between surfaces: own + reflected direct light.
std::vector<double> emitted_by(const LightSide& side);

/// lm/m2, what a side that is solved sends first: the guess; when its product is known, what the best
/// multiple of it leaves unbalanced; what is emitted without one.
std::vector<double> first_sent_by(const LightSide& side);

/// Sums reflections one by one (Neumann), with the bracket of their ratios. For a fixed number of
/// bounces, and for rows of which nothing shows that light dies out (the paper's near grid points).
class SideInSeries : public SideOnItsWay {
public:
    SideInSeries(const LightSide& side, RowSums rows, const BalanceLimits& limits);
    bool ended() const override { return ended_; }
    std::span<const double> leaving() const override { return leaving_; }
    void arrive(const std::vector<double>& arriving) override;
    Balance state() const override;

private:
    void look_at_tail();

    LightSide side_;
    RowSums rows_;
    BalanceLimits limits_;
    TailBounds tail_{{}};
    std::vector<double> last_, before_, sum_, leaving_;
    int bounces_ = 0;
    bool converged_ = false, ended_ = false;
};

/// Solves: the first reflections are sent one by one, so that they can be seen, then what the balance
/// still misses; the answer is the best mixture of all that was sent (Directions) and of uniform light,
/// bounded by comparison.
///
/// Needs     light that dies out: `comparison.dies_out()`; `comparison` and `rows` outlive it.
class SideSolved : public SideOnItsWay {
public:
    SideSolved(const LightSide& side, const RowSums& rows, const Comparison& comparison, const BalanceLimits& limits);
    bool ended() const override { return ended_; }
    std::span<const double> leaving() const override { return leaving_; }
    void arrive(const std::vector<double>& arriving) override;
    Balance state() const override;

private:
    void mix_in(std::vector<double> leaving, std::vector<double> arriving);
    void look_at_residual();
    void choose_next(const std::vector<double>& arriving);
    bool shows_bounces() const { return side_.guess.empty() && bounces_ <= limits_.first_bounces; }

    LightSide side_;
    const RowSums& rows_;
    const Comparison& comparison_;
    BalanceLimits limits_;
    Directions directions_;
    std::vector<double> emitted_, leaving_;
    std::vector<double> exitance_, arriving_, residual_;  ///< the mixture, its product, and what it misses
    std::vector<double> sum_;                             ///< lx, of the first reflections
    std::vector<double> low_, high_, rounding_;           ///< of what `arriving_` misses
    double residual_before_ = 0.0;
    int bounces_ = 0;
    bool one_by_one_ = false, converged_ = false, ended_ = false;
};

}  // namespace hanei
