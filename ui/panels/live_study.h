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

    /// Once a frame. During a gesture a running study may finish first, up to a second: restarted at
    /// every mouse movement, it would never answer. One that is known to take longer is given up for
    /// the newest place as soon as its picture with direct light is there. Error bars wait for the
    /// gesture's end.
    void follow(const Wish& wish);

    /// Stops what runs; the last answer stays until something is changed.
    void cancel();
    bool is_cancellable() const;  ///< it runs for so long that someone may want to stop it
    bool is_cancelled() const { return cancelled_; }

    /// Asks where the light at a place comes from, once there is a complete answer to the present wish;
    /// once a frame while it is wanted. Returns the last that is known of it, or null.
    std::shared_ptr<const Contributions> contributions(const Vec3& position, const Vec3& normal);

    const SolutionSnapshot& solution() const { return solution_; }  ///< null before the first
    const SolutionSnapshot& answer() const { return answer_; }      ///< the last complete one; null before the first
    bool fresh() const;  ///< the solution is complete and answers the present wish
    bool busy() const { return pending_ || job_.busy(); }
    bool settled() const {
        return fresh() || (!pending_ && (cancelled_ || fault() != nullptr));
    }  ///< nothing more will come
    const Progress& progress() const { return job_.progress(); }
    const Diagnostics& findings() const { return findings_; }  ///< of the scene started last, errors first
    const Diagnostic* fault() const;  ///< the first error that keeps the scene from being solved; null when none

    /// From a wish to what was shown of it, by the last that came; `count` numbers them.
    struct Delay {
        std::size_t count = 0;
        double seconds = 0.0;
    };
    Delay picture_delay() const { return picture_delay_; }  ///< to its direct light, or to the whole answer
    Delay answer_delay() const { return answer_delay_; }    ///< to the complete answer

    /// How old the last complete answer is, s; negative before the first.
    double answer_age() const;

    /// Seconds from the last change of the wish to its complete answer; negative while unknown.
    double answer_seconds() const { return answer_seconds_; }

private:
    using Clock = std::chrono::steady_clock;
    void take();
    void start();
    bool answers(const Solution& solution) const;
    bool is_patient() const;

    Job job_;
    std::shared_ptr<const Contributions> contributions_;
    Job::Question asked_;  ///< last
    Wish wish_;
    bool pending_ = false;  ///< the wish was not handed to the job yet
    bool started_ = false;
    bool cancelled_ = false;
    Clock::time_point started_at_, wished_at_;
    Clock::time_point started_wish_at_;  ///< when what was started was wished
    SceneSnapshot started_scene_;
    double expected_seconds_ = 0.0;  ///< that a study within a gesture takes, by the last one
    SolutionSnapshot solution_, answer_;
    Clock::time_point answered_at_;
    Delay picture_delay_, answer_delay_;
    bool is_pictured_ = false;  ///< something of what was started is shown
    Diagnostics findings_;
    SceneSnapshot final_scene_;  ///< last one started outside a gesture: its answer has error bars
    double answer_seconds_ = -1.0;
};

std::string_view name_of(Stage stage);

}  // namespace hanei
