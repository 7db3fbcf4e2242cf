/// Light that opaque luminaires take from each other.
#pragma once

#include "engine/direct/direct.h"

#include <optional>

namespace hanei {

/// Luminous flux from one emitter at full output that arrives on the bodies of other luminaires. They are
/// no surfaces of the scene and reflect nothing: in a closed room
///
///     flux of the emitter = sum over patches of area x mean illuminance + this
///
/// Needs     occluders of the scene, luminaires among them.
/// Returns   0 where none of the bodies is a luminaire's; empty when stopped.
/// Cost      as mean_direct_estimates over the bodies' faces.
std::optional<Estimate> flux_on_luminaires(const Emitter& emitter, const Scene& scene, const OccluderSet& occluders,
                                           const Accuracy& accuracy, const Work& work);

}  // namespace hanei
