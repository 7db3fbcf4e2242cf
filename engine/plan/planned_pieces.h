/// The furniture of a scene, as rows of the plan.
#pragma once

#include "engine/plan/cost_model.h"
#include "engine/plan/plan.h"

namespace hanei {

/// One a piece, in the scene's order, with what the paper decides by and what skipping it saves; no bounds yet.
std::vector<PlannedPiece> planned_pieces(const Scene& scene, std::span<const Face> faces, const CostModel& cost);

}  // namespace hanei
