/// Notes how long each stage took and tells the progress where the study is.
#pragma once

#include "engine/solution/solution.h"

#include <chrono>

namespace hanei {

class StageClock {
public:
    explicit StageClock(Progress* progress) : progress_(progress) {}

    /// Ends the stage before, begins this one. The same stage may be entered again: times add up.
    void enter(Stage stage);
    /// Of the present stage; it counts as reused when something was kept and nothing made anew.
    void mark_reused(bool reused) { (reused ? kept_ : made_) = true; }
    std::vector<StageTime> finish();

private:
    void close();

    Progress* progress_;
    std::vector<StageTime> times_;
    Stage stage_ = Stage::idle;
    bool kept_ = false, made_ = false;
    std::chrono::steady_clock::time_point since_;
};

}  // namespace hanei
