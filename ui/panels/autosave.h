/// Keeps unsaved work where a crash cannot reach it.
#pragma once

#include "ui/panels/document.h"
#include "ui/panels/recovery_door.h"

#include <condition_variable>
#include <mutex>
#include <thread>

namespace hanei {

/// Work is kept after every step, a second after the one before at the earliest, and never for more than
/// a tenth of the time; during a step at least once an interval. A thread of its own turns it into text
/// and waits for the disk; where that refuses it is tried again. What is saved is forgotten. Every member is for the UI
/// thread.
///
/// Weak when the power fails within that second: then the step before is what is left.
/// Cost      two comparisons a frame; a lock and three pointers when something changed.
class Autosave {
public:
    /// `wake` is called from the thread when a fault is to be told.
    Autosave(RecoveryDoor door, std::function<void()> wake);

    /// What is on its way is kept first; what is kept stays, unless end() was called.
    ~Autosave();
    Autosave(const Autosave&) = delete;
    Autosave& operator=(const Autosave&) = delete;

    void follow(const Document& document, double interval_seconds);  ///< once a frame
    void end();                                                      ///< the user gave up, or saved, everything

    /// Work that was taken over from another window is discarded there as soon as it is kept here.
    void take_over(LostWork work);

    std::optional<Diagnostic> take_fault();  ///< why work could not be kept, once a reason

private:
    using Clock = std::chrono::steady_clock;
    struct Work {
        SceneSnapshot scene;
        Settings settings;
        std::filesystem::path original;
        bool in_step = false;
    };
    void hand_over(std::optional<Work> work, double interval_seconds);
    void run(const std::stop_token& stop);
    void keep(const Work& work);

    RecoveryDoor door_;
    std::function<void()> wake_;
    std::optional<Work> handed_;  ///< what the thread was told last

    std::mutex guard_;  ///< of everything below
    std::condition_variable_any told_;
    std::optional<Work> waiting_;
    bool forgets_ = false;
    Clock::duration interval_{};
    Clock::time_point last_kept_;
    Clock::duration took_{};
    std::vector<LostWork> taken_over_;
    std::optional<Diagnostic> fault_;
    std::string refused_;  ///< why work could not be kept the last time; empty when it could
    std::jthread thread_;  ///< last: it ends before what it uses
};

}  // namespace hanei
