/// What light straight from luminaires would be off by, at most, if less of it were simulated.
#pragma once

#include "engine/geometry/configuration_factor.h"
#include "engine/scene/scene.h"

#include <span>
#include <vector>

namespace hanei {

/// lx at every place, dimmed and maintained, to 1e-6 lx; infinite where a luminaire of known intensity touches it.
struct DirectChanges {
    std::vector<double> shadows;   ///< nothing casts a shadow
    std::vector<double> penumbra;  ///< every shadow has a hard edge: an opening is hidden as its middle is
    std::vector<double> openings;  ///< measured luminaires shine from their middle
};

/// A luminaire that nothing can hide adds nothing to shadows; any other all that it could bring (DirectCeiling).
/// Openings are bounded by their certificate (point_certificate.h) where nothing is in the way.
///
/// Cost      1 us a pair of place and luminaire, and 2 ns each obstacle; past some thousand obstacles every
///           luminaire may be hidden.
DirectChanges direct_changes(const Scene& scene, std::span<const Receiver> places);

}  // namespace hanei
