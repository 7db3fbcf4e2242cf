/// One configuration of a sweep, from nothing and again with other numbers of interreflections.
#pragma once

#include "engine/base/progress.h"
#include "engine/study/sweep_errors.h"

#include <memory>
#include <optional>

namespace hanei {

/// What one run gave, and what it took.
struct SweepAnswer {
    std::vector<ComparedValue> values;
    std::size_t unknowns = 0;
    std::vector<StageTime> times;
    double milliseconds = 0.0;
    SolutionSnapshot solution;  ///< of a run without shadows between surfaces with values at points alone

    double balance_ms() const;
};

/// Keeps what does not change with the number of interreflections.
class SweepRun {
public:
    /// `shadows`: whether light between surfaces is hidden by what stands between them. Direct light is
    /// the same either way.
    SweepRun(SceneSnapshot scene, const Settings& settings, bool shadows, std::vector<std::string> point_sets);
    ~SweepRun();
    SweepRun(SweepRun&&) noexcept;

    /// Returns   empty when stopped.
    std::optional<SweepAnswer> with_bounces(int bounces, const Work& work);

private:
    struct Parts;
    std::unique_ptr<Parts> parts_;
};

}  // namespace hanei
