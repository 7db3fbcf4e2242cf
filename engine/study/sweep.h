/// Accuracy against time: every method at several patch widths on one scene.
#pragma once

#include "engine/base/progress.h"
#include "engine/plan/settings.h"
#include "engine/scene/scene.h"

#include <string>
#include <vector>

namespace hanei {

/// Errors at the points of one set, shares of the expected value; where that is less than a tenth of the
/// set's mean, of this tenth, so that dark places do not count for more than they light.
struct SweepErrors {
    std::string set;  ///< name of a grid, "points", a reference case's set; "all": every point
    double mean = 0.0;
    double p95 = 0.0;
    double max = 0.0;
};

/// One run.
struct SweepPoint {
    Method method = Method::patch;
    double max_patch = 0.0;  ///< m
    std::size_t unknowns = 0;
    double milliseconds = 0.0;        ///< from nothing to every value, the fastest of a few runs
    std::vector<SweepErrors> errors;  ///< of "all" first; the sets after it when there are several
};

struct Sweep {
    std::string against;  ///< what errors are errors of, in words
    std::vector<SweepPoint> points;
};

/// Values known from elsewhere.
struct SweepExpected {
    std::string source;             ///< in words: "the expected values of S2"
    std::vector<double> lux;        ///< one a calculation point of the scene; it has no grids then
    std::vector<std::string> sets;  ///< of these
};

/// Runs with patches of 4, 2, 1 and 1/2 times the width set; `linear`, with four unknowns a patch, twice
/// these; `paper` ends after ten interreflections. Errors are against `expected`; without it against a finest run,
/// `linear` at half the width.
///
/// Needs     calculation points or grids.
/// Returns   the runs that were finished when stopped.
/// Cost      that of the runs: some twenty studies, the finest with sixteen times the width's unknowns.
Sweep accuracy_sweep(const SceneSnapshot& scene, const Settings& settings, const SweepExpected* expected,
                     const Work& work);

}  // namespace hanei
