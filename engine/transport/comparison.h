/// A rigorous bound on what is missing in an exitance that does not balance yet, by comparison.
#pragma once

#include <span>
#include <vector>

namespace hanei {

/// Let A = reflectance x rows, with no coefficient below 0, and w > 0 an exitance of which a reflection
/// leaves less everywhere: lost = w - A w > 0. Then light dies out, (1 - A) has an inverse without a
/// negative coefficient, and of an exitance b with the residual r = emitted + A b - b
///
///     w min(r / lost)  <=  converged - b  <=  w max(r / lost)       for every unknown,
///
/// and the light that is still to arrive lies between rows x w times the same two numbers. Two such w
/// cost no more than the row sums: 1 everywhere, and the reflectance. Where surfaces that reflect
/// everything lose light only by seeing others, both fail, and w = 1 + A 1 + A A 1 + ... is grown until
/// it serves, a product for each. Of several w the narrower bound holds.
///
/// Holds     for the rows as they are multiplied: what rounding to stored floats, halves or shares in
///           256 steps changed of them is an error of the rows, not of the balance, and not in it.
/// Weak when the residual is large at a few unknowns alone: the bound is as wide as if it were so
///           everywhere. It then exceeds the error some ten times.
/// Cost      a few operations an unknown and w.
class Comparison {
public:
    /// `plain`: row sums of what is multiplied; `reflecting`: its product with the reflectance.
    Comparison(std::span<const double> reflectance, std::span<const double> plain, std::span<const double> reflecting);

    /// One w at least serves: every series of reflections converges. Else nothing can be bounded.
    bool dies_out() const { return !serving_.empty(); }

    /// What to send through the rows for a w that may serve, and what arrived of it. Empty when growing
    /// is no use: some row gives back more than it got.
    std::span<const double> growing() const { return growing_; }
    void grow(std::span<const double> arriving);

    /// `low` and `high`, one an unknown, become bounds of the light still to arrive. `rounding` is how
    /// far each residual may be off.
    void bound(std::span<const double> residual, std::span<const double> rounding, std::span<double> low,
               std::span<double> high) const;

private:
    /// One w: what arrives of it, and what a reflection of it loses.
    struct Uniform {
        std::vector<double> arriving, lost;
    };
    static void narrow(const Uniform& light, std::span<const double> residual, std::span<const double> rounding,
                       std::span<double> low, std::span<double> high);

    std::span<const double> reflectance_;
    std::vector<Uniform> serving_;
    std::vector<double> growing_;   ///< A A ... 1
    std::vector<double> arriving_;  ///< rows x the sum of all that before it
};

}  // namespace hanei
