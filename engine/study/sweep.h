/// Accuracy against time: methods, patch widths, numbers of interreflections and shadows between surfaces
/// on one scene.
#pragma once

#include "engine/base/progress.h"
#include "engine/plan/settings.h"
#include "engine/scene/scene.h"
#include "engine/study/lumen_point.h"
#include "engine/study/presets.h"
#include "engine/study/sweep_errors.h"

#include <functional>
#include <string>
#include <vector>

namespace hanei {

/// What a run stands for besides itself.
struct SweepMarks {
    bool current = false;  ///< the settings of the project
    bool paper = false;    ///< the paper's own: its method, the width set, four interreflections, shadows
    std::optional<Preset> preset{};
    bool any() const { return current || paper || preset; }
    bool operator==(const SweepMarks&) const = default;
};

/// One run.
struct SweepPoint {
    Settings settings;
    bool shadows = true;   ///< between surfaces; direct light always has them
    bool complete = true;  ///< all interreflections that the method is good for, not a fixed few
    SweepMarks marks{};
    std::size_t unknowns = 0;
    double milliseconds = 0.0;          ///< from nothing to every value, without the coarser solution of error bars
    Prediction predicted{};             ///< before the study began
    std::vector<SweepErrors> errors{};  ///< of "all" first; the sets after it when there are several
    bool on_frontier = false;           ///< of the 95th percentile over all points
};

/// A run that would have taken too long.
struct OmittedRun {
    Settings settings;
    bool shadows = true;
    double predicted_ms = 0.0;  ///< or what it had when it was ended, not done yet
};

struct Sweep {
    std::string against;              ///< what errors are errors of, in words
    std::string uncertainty_words{};  ///< where its own uncertainty comes from, in words
    SweepErrors uncertainty{};        ///< of what errors are errors of: smaller errors mean nothing
    std::vector<SweepPoint> points{};
    std::vector<OmittedRun> left_out{};
    LumenPoint lumen{};
    bool something_between = true;  ///< else shadows between surfaces make no difference, and are not tried
    double budget_s = 0.0, spent_s = 0.0;
    double processor_s = 0.0;  ///< of all threads, while this took spent_s
    bool stopped = false;      ///< before all runs were done
    std::vector<CalibrationSample> learned{};
};

/// Values known from elsewhere.
struct SweepExpected {
    std::string source;               ///< in words: "the expected values of S2"
    std::vector<double> lux;          ///< one a calculation point of the scene; it has no grids then
    std::vector<std::string> sets;    ///< of these
    std::vector<double> uncertainty;  ///< lx, of these
};

struct SweepWish {
    const SweepExpected* expected = nullptr;  ///< null: errors are against the finest runs
    double budget = 60.0;                     ///< s: runs that are predicted to go beyond it are left out
    Calibration calibration{};
    std::function<void(const Sweep&)> on_way{};  ///< sees what is known so far, after every run
};

/// Runs every method with patches of 4, 2, 1 and 1/2 times the width set (`linear`, with four unknowns a
/// patch, twice these), each with 1, 2, 4, 10 and all interreflections (`paper` with 10 at most: between
/// close patches more would only grow), and all of it again as if nothing stood between surfaces; further
/// the present settings, the paper's own and the three presets. The soonest runs come first.
///
/// Errors are against `expected`; without it against the finest run of `linear` that is predicted to take no
/// more than a third of the budget, whose own uncertainty is its difference from the finest run of `patch` for a
/// sixth of it: of another kind and width. Where every run of `linear` would take longer, it is the finest
/// of `patch`, and its uncertainty the difference from patches twice as wide.
///
/// A run of fewer interreflections is the full one with its own time for the balance in place: nothing
/// else of it would be different.
///
/// Needs     calculation points or grids.
/// Returns   the runs that were finished when stopped.
///           No run at all when not even one to compare with fits into the budget.
/// Cost      the budget, as well as runs can be predicted.
Sweep accuracy_sweep(const SceneSnapshot& scene, const Settings& settings, const SweepWish& wish, const Work& work);

}  // namespace hanei
