/// How exact light from one luminaire must be.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace hanei {

/// By how much one luminaire's light at full output may be off at a place:
///
///     max(share x value, floor)
///
/// Nothing asked for (0, 0) means as exact as the models of sources are: exact to rounding but for
/// measured openings and means over patches. What is asked for is a limit of the estimated error that
/// comes with every value, not of the work: values are often better.
///
/// Openings that are no luminaire files, and points of them all, are exact whatever is allowed: accuracy
/// matters for measured openings and for means over patches.
struct Accuracy {
    double share = 0.0;  ///< of the luminaire's own value
    double floor = 0.0;  ///< lx: what matters nowhere, however dim the place is

    double allowed(double value) const { return std::max(share * value, floor); }
    bool operator==(const Accuracy&) const = default;
};

/// The accuracy to ask of each of `luminaires` so that their sum is off by at most `share` of itself or
/// of `dim`, whichever is more.
///
/// Errors of luminaires are independent: their squares add up, and each may be off by share x dim over
/// the root of their number without the sum being off by more than share x dim.
///
/// Needs     `dim` in lx at full output, below which places need no better: a tenth of the room's mean
///           illuminance, say.
inline Accuracy accuracy_of_each(double share, double dim, std::size_t luminaires) {
    return {share, share * dim / std::sqrt(static_cast<double>(std::max<std::size_t>(1, luminaires)))};
}

}  // namespace hanei
