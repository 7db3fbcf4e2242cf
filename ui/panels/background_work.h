/// What takes its time away from the frames: files that are read, pictures and models that are written.
#pragma once

#include "engine/base/progress.h"
#include "ui/panels/task_bar.h"
#include "ui/panels/time_left.h"

#include <chrono>
#include <condition_variable>
#include <functional>
#include <memory>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

namespace hanei {

/// One thing at a time, on a thread of its own; the newest wins. Every member is for the UI thread.
///
/// Weak when a job does not look at the wish to stop (stop_if_wished() will do): then it is left alone until it
///           ends, its outcome is thrown away, and closing the window waits for it.
class BackgroundWork {
public:
    /// What is to be done with what was made, on the UI thread.
    using Finish = std::function<void()>;
    /// Runs on the thread and touches nothing of the window. What it throws is told by `failed`.
    using Job = std::function<Finish(const Work&)>;
    using Failed = std::function<void(const std::string&)>;

    /// `wake` is called from the thread when it is done; a job that is done within `patience` (s) is finished
    /// by start() itself, as if it had taken no time.
    BackgroundWork(std::function<void()> wake, double patience, Failed failed)
        : wake_(std::move(wake)), patience_(patience), failed_(std::move(failed)) {}
    ~BackgroundWork();
    BackgroundWork(const BackgroundWork&) = delete;
    BackgroundWork& operator=(const BackgroundWork&) = delete;

    void start(std::string name, Job job);
    void cancel();  ///< nothing comes of it
    bool busy() const { return present_ != nullptr; }
    void follow();  ///< once a frame in which something may happen: finishes what is done
    Task task();    ///< while it is busy

private:
    struct Run {
        std::mutex guard;
        std::condition_variable ended;
        bool done = false;
        Finish finish;
        std::string failure;
        Progress progress;
        std::jthread thread;  ///< last: it ends before what it uses
    };
    static bool is_done(Run& run);
    void sweep();

    std::function<void()> wake_;
    double patience_;
    Failed failed_;
    std::string name_;
    TimeLeft left_;
    std::chrono::steady_clock::time_point begun_;
    std::shared_ptr<Run> present_;
    std::vector<std::shared_ptr<Run>> left_alone_;
};

}  // namespace hanei
