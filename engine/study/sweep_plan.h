/// Which runs a sweep is made of, in which order, and what they will take.
#pragma once

#include "engine/study/sweep.h"

namespace hanei {

/// A configuration, run from nothing once; then again with fewer interreflections.
struct PlannedRun {
    Settings settings;  ///< with all interreflections
    bool shadows = true;
    std::vector<int> fewer{};  ///< interreflections of the runs after the first, from many to few
    Prediction predicted{};
    std::optional<Preset> preset{};
    bool wanted = false;  ///< the present settings, the paper's own, a preset: before all others
};

/// All interreflections: what the method is good for.
int all_bounces(Method method);

/// Those that are wanted first, then the soonest first. The present settings and the paper's own are among
/// the others where they fit in: `fewer` holds their interreflections.
std::vector<PlannedRun> planned_runs(const Scene& scene, const Settings& settings, const Calibration& calibration,
                                     bool something_between);

/// What the point with so many interreflections stands for.
SweepMarks marks_of(const PlannedRun& run, int bounces, const Settings& present);

/// The finest patch width of the method, of the one set times powers of the root of two from 1/4 to 16, that is
/// predicted to take no longer than this; nothing when none is.
std::optional<Settings> finest_within(const Scene& scene, const Settings& settings, Method method, double ms,
                                      const Calibration& calibration);

}  // namespace hanei
