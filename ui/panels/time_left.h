/// How long a computation will still take, from how long it took so far.
#pragma once

#include "engine/base/progress.h"

#include <chrono>
#include <optional>
#include <string>

namespace hanei {

/// "12 s left", "3 min left"; empty where there is nothing to say.
std::string time_left_text(std::optional<double> seconds);

/// Asked again and again while a computation runs; a new stage begins anew.
class TimeLeft {
public:
    using Clock = std::chrono::steady_clock;

    /// Empty until half a second and 2 % of the stage have passed: before, it would only jump.
    std::optional<double> seconds(Stage stage, float fraction, Clock::time_point now = Clock::now());
    std::string text(Stage stage, float fraction) { return time_left_text(seconds(stage, fraction)); }

private:
    Stage stage_ = Stage::idle;
    Clock::time_point begun_ = Clock::now();
};

}  // namespace hanei
