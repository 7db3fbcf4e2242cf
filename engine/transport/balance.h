/// The balance of interreflection, reflection by reflection (the paper's equations 2 and 3), with a
/// two-sided bracket on what is still missing.
#pragma once

#include "engine/transport/factors.h"

#include <functional>
#include <optional>
#include <span>
#include <vector>

namespace hanei {

struct BalanceInput {
    const DenseRows* factors = nullptr;
    const Visibility* visibility = nullptr;  ///< null: everything sees everything
    std::span<const double> reflectance;     ///< one an unknown
    std::span<const double> direct;          ///< lx, arriving from luminaires
    std::span<const double> own_exitance;    ///< lm/m2, emitted by the surfaces themselves
};

struct BalanceLimits {
    int bounces = 1000;      ///< interreflections at most
    double accuracy = 1e-3;  ///< of the greatest total illuminance: stop when the bracket is closer
    int first_bounces = 3;   ///< sent, and shown by `on_bounce`, one by one before the rest is solved for
};

/// One state of the series. `interreflected` is the middle of the bracket once there is one (the
/// partial sum before, and always for a fixed number of bounces).
struct Balance {
    std::vector<double> interreflected;       ///< lx, one an unknown: light that arrives from surfaces
    std::vector<double> exitance;             ///< lm/m2, own + reflected
    std::vector<double> exitance_half_width;  ///< lm/m2: the converged exitance lies within this of it; a bound
    std::vector<double> sent, arrived;        ///< lm/m2 near `exitance`, and rows x that: a guess for the next balance
    int bounces = 0;                          ///< reflections summed up
    int products = 0;  ///< with the rows, those for the bounds included: each a pass over what is stored
    bool converged = false;
    double greatest_row_sum = 0.0;  ///< of reflectance x factor x visibility: below 1 the series converges
};

/// Neumann series. With q and p the greatest and least ratio of a reflection's exitance to the one
/// before over all unknowns, the tail lies elementwise between last * p/(1-p) and last * q/(1-q);
/// where q is not below 1 the row sums bound it instead (NUMERICS, solver).
///
/// `on_bounce`, when given, sees the state after every reflection and returns false to stop.
/// Returns   empty when stopped.
std::optional<Balance> balance(const BalanceInput& input, const BalanceLimits& limits, const Work& work,
                               const std::function<bool(const Balance&)>& on_bounce = nullptr);

/// Light exchanged once between all unknowns: arriving = rows x leaving, for several right-hand sides
/// at once. Side s of unknown j stands at j * sides + s, in `leaving` and in `arriving`.
/// Needs     coefficients that are not negative; the same bits on any number of threads.
/// Returns   false when stopped.
using Exchange = std::function<bool(std::span<const double> leaving, std::span<double> arriving, std::size_t sides)>;

/// The exchange by rows that lie in memory; they must outlive it.
Exchange exchange_by(const DenseRows& factors, const Visibility* visibility, const Work& work);

/// One right-hand side: the light of one luminaire group in one colour band. All spans have one value
/// an unknown.
struct LightSide {
    std::span<const double> reflectance;          ///< in this band
    std::span<const double> direct;               ///< lx, arriving from luminaires
    std::span<const double> own_exitance;         ///< lm/m2, emitted by the surfaces themselves
    std::span<const double> guess = {};           ///< lm/m2, an exitance to start from; empty: there is none
    std::span<const double> guess_arriving = {};  ///< lx, rows x guess, when that is known; saves its product
};

/// The balance of several sides, each product with the rows shared by all that are not done yet.
///
/// The first reflections are summed one by one; then the exitance is the mixture of all reflections
/// sent so far that leaves the least unbalanced, and what is unbalanced is sent next (generalised
/// conjugate residuals; rows of a room need not be symmetric). `exitance_half_width` comes from the
/// comparison with uniform light (comparison.h): a bound for every unknown, and what ends the iteration.
/// Up to 20 bounces asked for are summed as they are: `balance` above for every side. So are rows of
/// which nothing shows that light dies out (the paper's near grid points, reflectance 1 in a closed room).
///
/// `on_bounce`, when given, sees the states of all sides after every product and returns false to stop;
/// the first are the sums of 1, 2, 3 bounces, with how much is still to come.
/// A guess may be any exitance: one near the answer, or near a multiple of it (light that was dimmed),
/// saves products; a bad one costs one. `sent` and `arrived` of an earlier balance by the same rows
/// (a luminaire moved, a reflectance changed) go in as `guess` and `guess_arriving`; when the rows have
/// changed, only the guess.
///
/// Returns   one a side, in their order; empty when stopped.
/// Holds     the same bits on any number of threads. The bound is on the balance of the rows as they
///           are: not on what their storage rounded away, nor on the mesh.
/// Weak when a closed room reflects nearly all light: reflectance 0.99 takes 50 products to 1e-6. Surfaces
///           of reflectance 1 cost a few products more to show that light dies out.
/// Cost      an office (reflectances 0.2 to 0.8): 5 products to 1e-3, 10 to 1e-6; one pass over the rows
///           each. Of memory some 10 values, and 3 a product (48 at most), an unknown and side.
std::optional<std::vector<Balance>> balance(const Exchange& exchange, std::size_t unknowns,
                                            std::span<const LightSide> sides, const BalanceLimits& limits,
                                            const Work& work,
                                            const std::function<bool(std::span<const Balance>)>& on_bounce = nullptr);

/// Illuminance at receivers gathered from exitances: rows x exitance.
std::vector<double> gather(const DenseRows& factors, const Visibility* visibility, std::span<const double> exitance,
                           const Work& work);

/// Exitance of patches from that of their corners (for the paper's method): the mean of the corners.
std::vector<double> patch_exitance(const Mesh& mesh, std::span<const double> vertex_exitance);

}  // namespace hanei
