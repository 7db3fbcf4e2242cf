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
    int bounces = 1000;       ///< interreflections at most
    double accuracy = 1e-3;   ///< of the greatest total illuminance: stop when the bracket is closer
};

/// One state of the series. `interreflected` is the middle of the bracket once there is one (the
/// partial sum before, and always for a fixed number of bounces).
struct Balance {
    std::vector<double> interreflected;  ///< lx, one an unknown: light that arrives from surfaces
    std::vector<double> exitance;        ///< lm/m2, own + reflected
    std::vector<double> exitance_half_width;  ///< lm/m2: the converged exitance lies within this of it; a bound
    int bounces = 0;
    bool converged = false;
    double greatest_row_sum = 0.0;       ///< of reflectance x factor x visibility: below 1 the series converges
};

/// Neumann series. With q and p the greatest and least ratio of a reflection's exitance to the one
/// before over all unknowns, the tail lies elementwise between last * p/(1-p) and last * q/(1-q);
/// where q is not below 1 the row sums bound it instead (NUMERICS, solver).
///
/// `on_bounce`, when given, sees the state after every reflection and returns false to stop.
/// Returns   empty when stopped.
std::optional<Balance> balance(const BalanceInput& input, const BalanceLimits& limits, const Work& work,
                               const std::function<bool(const Balance&)>& on_bounce = nullptr);

/// Illuminance at receivers gathered from exitances: rows x exitance.
std::vector<double> gather(const DenseRows& factors, const Visibility* visibility, std::span<const double> exitance,
                           const Work& work);

/// Exitance of patches from that of their corners (for the paper's method): the mean of the corners.
std::vector<double> patch_exitance(const Mesh& mesh, std::span<const double> vertex_exitance);

}  // namespace hanei
