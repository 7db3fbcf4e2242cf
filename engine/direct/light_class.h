/// Which patches a luminaire lights wholly, in part or not at all: the paper's third step, by proof.
#pragma once

#include "engine/direct/direct.h"
#include "engine/mesh/light_class.h"

#include <optional>
#include <span>
#include <vector>

namespace hanei {

/// How thoroughly an umbra is looked for.
struct ClassEffort {
    static constexpr int single_bodies = -1;  ///< only umbrae that one body casts
    int halvings = single_bodies;             ///< else patch and opening are halved this often at most
};

/// The class of a patch towards a luminaire.
///
///     lit     no body reaches into the convex hull of patch and opening (separating axes)
///     umbra   bodies block every sight line between the two (shadow_proof.h)
///     away    the opening lies behind the patch, or the patch behind the opening
///
/// Each convex piece of the opening is asked for itself, with the patch cut at the piece's front and
/// the piece at the patch's horizon. The luminaire's own body hides nothing of it.
///
/// Needs     a convex polygon; `occluders` may be null (nothing casts shadows); `among`, when given,
///           all bodies that can be in the way, ascending.
/// Returns   in `between` (overwritten) the bodies that stand in some sight line; empty unless partly.
/// Holds     never a wrong proof, but along seams of bodies that touch; light of openings lower than
///           tolerance::touching above a patch counts as none.
/// Weak when a luminous solid that is not convex hides parts of itself: that is not asked.
/// Cost      1 us in free light, 2 to 20 us where bodies are near.
LightClass classify(const ReceivingPolygon& patch, const Emitter& emitter, const OccluderSet* occluders,
                    const std::optional<std::span<const BodyIndex>>& among, std::vector<BodyIndex>& between,
                    const ClassEffort& effort = {});

/// The class of every patch; empty when stopped.
std::optional<std::vector<LightClass>> light_classes(std::span<const ReceivingPolygon> patches, const Emitter& emitter,
                                                     const OccluderSet* occluders, const Work& work);

}  // namespace hanei
