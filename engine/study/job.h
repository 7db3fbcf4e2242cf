/// Studies in the background.
#pragma once

#include "engine/study/study.h"

#include <condition_variable>
#include <functional>
#include <mutex>
#include <optional>
#include <thread>

namespace hanei {

/// Runs studies one at a time on a thread of its own. Every member is for the UI thread alone.
/// In goes a snapshot, out comes a finished Solution; nothing else is ever shared.
class Job {
public:
    /// `wake` is called from the job's thread when something new can be taken.
    explicit Job(std::function<void()> wake);
    ~Job();

    void start(SceneSnapshot scene, const Settings& settings, const StudyRequest& request);  ///< the newest wins
    void cancel();             ///< the running study ends within a tile's time
    SolutionSnapshot take();   ///< once a frame; null when there is none new
    bool busy() const;
    const Progress& progress() const { return progress_; }

private:
    Progress progress_;
    // the implementation adds its thread and its mailbox here
};

}  // namespace hanei
