/// Keeps the newest answer to what is shown.
#pragma once

#include "engine/base/diagnostic.h"
#include "engine/study/job.h"

#include <chrono>
#include <functional>
#include <string>

namespace hanei {

/// Starts a study when the shown scene, the settings or the wished parts change, and takes what it
/// brings. The last answer stays until a newer one is there; it is stale when its request differs.
class LiveStudy {
public:
    /// `wake` is called from the job's thread when there is something new to show.
    explicit LiveStudy(std::function<void()> wake);

    struct Wish {
        SceneSnapshot scene;
        Settings settings;
        bool unshadowed = false;  ///< the part without shadows is looked at
        bool in_gesture = false;  ///< the next scene will follow in a moment
        bool shadows = false;     ///< classes or outlines of shadows are looked at
    };

    /// Once a frame. During a gesture a running study may finish first, or run 0.25 s: restarted at
    /// every mouse movement, it would never answer. Error bars wait for the gesture's end.
    void follow(const Wish& wish);

    const SolutionSnapshot& solution() const { return solution_; }  ///< null before the first
    const SolutionSnapshot& answer() const { return answer_; }      ///< the last complete one; null before the first
    bool fresh() const;  ///< the solution is complete and answers the present wish
    bool busy() const { return pending_ || job_.busy(); }
    bool settled() const { return fresh() || (!pending_ && fault() != nullptr); }  ///< nothing more will come
    const Progress& progress() const { return job_.progress(); }
    const Diagnostics& findings() const { return findings_; }  ///< of the scene started last, errors first
    const Diagnostic* fault() const;  ///< the first error that keeps the scene from being solved; null when none

    /// Seconds from the last change of the wish to its complete answer; negative while unknown.
    double answer_seconds() const { return answer_seconds_; }

private:
    using Clock = std::chrono::steady_clock;
    void take();
    void start();
    bool answers(const Solution& solution) const;

    Job job_;
    Wish wish_;
    bool pending_ = false;  ///< the wish was not handed to the job yet
    bool started_ = false;
    Clock::time_point started_at_, wished_at_;
    SolutionSnapshot solution_, answer_;
    Diagnostics findings_;
    SceneSnapshot final_scene_;  ///< last one started outside a gesture: its answer has error bars
    double answer_seconds_ = -1.0;
};

std::string_view name_of(Stage stage);

}  // namespace hanei
