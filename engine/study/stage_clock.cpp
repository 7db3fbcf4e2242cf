#include "engine/study/stage_clock.h"

#include <algorithm>

namespace hanei {

void StageClock::close() {
    if (stage_ == Stage::idle) return;
    const bool reused = kept_ && !made_;
    const double ms = std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - since_).count();
    const auto entry =
        std::find_if(times_.begin(), times_.end(), [&](const StageTime& time) { return time.stage == stage_; });
    if (entry == times_.end()) {
        times_.push_back({stage_, ms, reused});
    } else {
        entry->ms += ms;
        entry->reused = entry->reused && reused;
    }
}

void StageClock::enter(Stage stage) {
    close();
    stage_ = stage;
    kept_ = made_ = false;
    since_ = std::chrono::steady_clock::now();
    if (progress_) progress_->enter(stage);
}

std::vector<StageTime> StageClock::finish() {
    close();
    stage_ = Stage::idle;
    return times_;
}

}  // namespace hanei
