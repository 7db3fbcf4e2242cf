/// Light from one luminaire on part of a patch: a value, how far to trust it, and how to look closer.
#pragma once

#include "engine/direct/direct.h"
#include "engine/direct/flat_cell.h"

#include <span>
#include <vector>

namespace hanei {

/// An emitter and the bodies that can stand between it and a patch.
struct LightOnPatch {
    const Emitter& emitter;
    const OccluderSet* occluders;
    std::span<const BodyIndex> bodies;  ///< ascending
    Vec3 normal;                        ///< of the patch
    Accuracy accuracy;
};

/// Part of a patch under all of a luminaire's light, taken at the cell's nodes.
struct ReceivingCell {
    FlatCell patch;
    double weight = 1.0;  ///< of the whole patch
    Estimate mean;        ///< weight x mean illuminance

    void measure(const LightOnPatch& light);
    std::vector<ReceivingCell> halves() const;
};

/// Part of a patch under the light of part of a luminous piece. From each of the opening's nodes the part
/// of the patch is cut out that is seen past the bodies, and lit from there: shadows have exact borders, and
/// a penumbra is made of as many shadows as the opening has nodes. The first look is from its centre alone,
/// which is enough where the light hardly matters.
struct ShadowedCell {
    FlatCell patch, opening;
    std::size_t piece = 0;
    double weight = 1.0;  ///< of the whole patch and the whole piece
    Estimate mean;
    enum class Next { nodes, patch, opening } next = Next::nodes;  ///< what looking closer begins with

    void measure(const LightOnPatch& light);
    std::vector<ShadowedCell> halves() const;

    void measure_from_centre(const LightOnPatch& light);
};

}  // namespace hanei
