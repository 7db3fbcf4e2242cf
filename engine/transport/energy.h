/// Where the light between surfaces goes, counted node by node and not by difference.
#pragma once

#include <span>

namespace hanei {

/// One side of light, one value an unknown in each span.
struct LightOnNodes {
    std::span<const double> areas;  ///< m2 that each unknown stands for
    std::span<const double> reflectance;
    std::span<const double> own_exitance;    ///< lm/m2
    std::span<const double> direct;          ///< lx
    std::span<const double> interreflected;  ///< lx
    std::span<const double> row_sums;        ///< of factors x visibility: the share of what is seen that is a surface
};

/// lm. What luminaires send that meets no surface is not in here: their flux less `direct`.
struct FluxAccount {
    double own = 0.0;     ///< emitted by the surfaces themselves
    double direct = 0.0;  ///< arrived from luminaires
    double absorbed = 0.0;
    double escaped = 0.0;   ///< left a surface for where none is seen: through openings, to surfaces' backs
    double sent = 0.0;      ///< left a surface for another
    double received = 0.0;  ///< arrived from surfaces

    /// What was sent and not received: own + direct = absorbed + escaped + imbalance.
    double imbalance() const { return sent - received; }
};

/// Light that leaves unknown i meets no surface in the share (1 - row sum of i) of all directions, as
/// they are weighed by Lambert's law; the row of i says so, whereas what arrives elsewhere is said by
/// the other rows. With exact form factors both agree (A_i F_ij = A_j F_ji); of rows taken at nodes they
/// do not quite, and the imbalance is their error in lumens.
///
/// Needs     an exitance that is own + reflectance x (direct + interreflected).
/// Holds     own + direct = absorbed + escaped + imbalance to rounding, whatever the rows are; all light
///           counted once. `escaped` is never below 0: a row sum above 1 (the paper's near grid points)
///           is light that was sent.
/// Weak when errors of both signs cancel: the imbalance is one figure a room. Bounces that were not
///           waited for are in it, too: light sent that has not arrived.
/// Cost      some ten operations an unknown.
FluxAccount account_of(const LightOnNodes& light);

}  // namespace hanei
