/// What a run writes into its solution besides values at points.
#pragma once

#include "engine/study/level.h"

namespace hanei {

/// What the level's patches have: values, means of faces and the flux balance.
void take_answer(Solution& solution, const Level& level, const LevelAnswer& answer);

/// Times of the stages, and of the effects that they computed.
void take_times(Solution& solution, std::vector<StageTime> times);

/// Says in a sentence that patches were made wider than asked, when they were.
void note_width(Solution& solution);

/// Says in a sentence why the iteration did not end, when it did not.
void note_divergence(Solution& solution);

}  // namespace hanei
