/// Exitances whose product with the rows is known, and the best mixture of them.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace hanei {

/// Generalised conjugate residuals (Eisenstat, Elman & Schultz 1983): directions u with F u known, made
/// orthogonal in (1 - A) u, A = reflectance x F. The mixture that leaves the least residual is found
/// one direction at a time, and any exitance whose product is known can be one: the first reflections,
/// a guess, uniform light.
///
/// Holds     the latest `most` directions; rows of a room are nearly symmetric (reciprocity), so that
///           older ones hardly matter.
/// Cost      8 operations an unknown and direction held, for each new one.
class Directions {
public:
    struct Direction {
        std::vector<double> leaving;   ///< u
        std::vector<double> arriving;  ///< F u
        std::vector<double> missing;   ///< (1 - A) u, of length 1
    };

    explicit Directions(std::size_t most) : most_(most) {}

    /// Null when the direction is, but for rounding, a mixture of those held.
    const Direction* add(std::span<const double> reflectance, std::vector<double> leaving,
                         std::vector<double> arriving);

private:
    std::size_t most_, oldest_ = 0;
    std::vector<Direction> held_;
};

/// a . b, in an order of its own: the same on any number of threads.
double dot(std::span<const double> a, std::span<const double> b);

}  // namespace hanei
