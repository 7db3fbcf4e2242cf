/// Divides the light at a place by what is kept of the study that solved it.
#pragma once

#include "engine/study/contributions.h"
#include "engine/study/level.h"

namespace hanei {

struct AskedPlace {
    Vec3 position{0.0};
    Vec3 normal{0.0, 0.0, 1.0};  ///< unit
};

/// Needs     the level and its answer that the solution was made from, and the input of that solve.
/// Returns   empty when stopped.
std::optional<Contributions> contributions_at(const SolutionSnapshot& solution, const Level& level,
                                              const LevelAnswer& answer, const LevelInput& input,
                                              const AskedPlace& place, const Work& work);

}  // namespace hanei
