/// A mesh cut finer where the light on it says so.
#pragma once

#include "engine/study/level.h"

#include <memory>
#include <span>

namespace hanei {

/// What the wished values ask of a patch: its share of all area, and what it gives to each calculation
/// point as a share of that point's illuminance.
struct WishedValues {
    std::span<const Receiver> points;
    std::span<const double> illuminance;  ///< lx, one a point
};

/// The level's mesh with the patches cut that misplace most light (refinement_need.h): by `growth` of
/// their number more.
///
/// Needs     a level that was solved for `input` with this answer.
/// Returns   null when stopped.
std::shared_ptr<const Mesh> finer_mesh(Level& level, const LevelAnswer& answer, const WishedValues& wished,
                                       double growth, const LevelInput& input, const Work& work, StageClock& clock);

/// lx that elements may misplace at each place, as an estimate: every patch with the most that it misses at its
/// corners. Means over its quarters are right, so that what it misses cancels from afar.
///
/// Returns   empty when stopped.
std::optional<std::vector<double>> misplaced_light(Level& level, const LevelAnswer& answer,
                                                   std::span<const Receiver> places, const LevelInput& input,
                                                   const Work& work, StageClock& clock);

}  // namespace hanei
