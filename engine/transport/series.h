/// Parts of the Neumann series: products with the factors, and bounds on what is still to come.
#pragma once

#include "engine/transport/factors.h"

#include <span>
#include <vector>

namespace hanei {

/// arriving[i] = sum over j of factor x visibility x leaving[j], in double, in the order of j.
/// False when stopped. Same bits on any number of threads.
bool multiply(const DenseRows& factors, const Visibility* visibility, std::span<const double> leaving,
              std::span<double> arriving, const Work& work);

/// The same for several right-hand sides at once: side s of unknown j stands at j * sides + s.
bool multiply(const DenseRows& factors, const Visibility* visibility, std::span<const double> leaving,
              std::span<double> arriving, std::size_t sides, const Work& work);

/// A reflection keeps at most this share of what there was: row sums of factor x visibility x
/// reflectance, and of factor x visibility.
struct RowSums {
    std::vector<double> plain;
    std::vector<double> reflecting;
    double greatest_plain = 0.0;
    double greatest = 0.0;  ///< of `reflecting`: below 1 the series converges
};
std::optional<RowSums> row_sums(const DenseRows& factors, const Visibility* visibility,
                                std::span<const double> reflectance, const Work& work);

/// Least and greatest ratio of one reflection to the one before. With factors >= 0 every later
/// reflection keeps within them: if q x <= y elementwise, q A x <= A y.
struct Ratios {
    double least = 0.0;
    double greatest = 0.0;
};
Ratios ratios_of(std::span<const double> last, std::span<const double> before);

/// Bounds of a tail that nothing is known about.
inline constexpr double unbounded = 1e30;

/// The sum of all reflections to come, per unknown.
class TailBounds {
public:
    explicit TailBounds(std::vector<double> high) : high_(std::move(high)), low_(high_.size(), 0.0) {}

    /// last x p/(1-p) <= tail <= last x q/(1-q); each bound replaces a weaker one.
    void narrow(const Ratios& ratios, std::span<const double> last);

    double low(std::size_t k) const { return low_[k]; }
    double high(std::size_t k) const { return high_[k]; }
    bool is_bracket() const { return bracket_; }  ///< both sides are known by the ratios
    bool diverges() const { return diverges_; }   ///< every reflection is at least as strong as the one before
    double greatest_half_width() const;

private:
    std::vector<double> high_, low_;
    bool bracket_ = false;
    bool diverges_ = false;
};

/// With `leaving` the greatest exitance on its way: it arrives at i as leaving x plain_i at most, and
/// all that follows is at most leaving x reflecting_i x greatest_plain / (1 - greatest).
TailBounds tail_by_row_sums(const RowSums& rows, double leaving);

/// A reflection stronger than this has run away (closest grid points of the paper's factors).
inline constexpr double too_large = 1e25;

}  // namespace hanei
