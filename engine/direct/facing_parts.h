/// The parts of a flat receiver and of a luminous piece that face each other.
#pragma once

#include "engine/direct/direct.h"
#include "engine/geometry/polygon.h"

#include <optional>

namespace hanei {

struct FacingParts {
    Polygon patch;
    Polygon opening;
};

/// The patch cut at the piece's front, and the piece at the patch's horizon. Nothing when one lies
/// wholly behind the other; less than tolerance::touching before counts as behind.
std::optional<FacingParts> facing_parts(const ReceivingPolygon& patch, const LuminousPiece& piece);

}  // namespace hanei
