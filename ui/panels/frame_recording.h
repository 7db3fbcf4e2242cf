/// A drag or a growing solution as numbered pictures, for an animation.
#pragma once

#include "ui/panels/task_bar.h"
#include "ui/view/image.h"

#include <chrono>
#include <condition_variable>
#include <deque>
#include <filesystem>
#include <functional>
#include <mutex>
#include <optional>
#include <thread>

namespace hanei {

/// Pictures are packed and written on a thread of its own: frame-00001.png, ... and index.csv with the
/// seconds of each and what was shown. Every member is for the UI thread.
///
/// Weak when the disk is slower than the screen for long: past 512 MB that wait, pictures are left out, and
///           the index says how many.
class FrameRecording {
public:
    ~FrameRecording();

    /// Into a new folder "NAME recording 2026-11-22 15-04-05" there. Returns why it cannot be, or nothing.
    std::optional<std::string> start(const std::filesystem::path& where, const std::string& name);
    /// Takes no more. What waits is still written: within `patience` (s) here, else in the background.
    void stop(double patience);
    bool is_on() const { return is_on_; }
    bool is_writing() const { return writing_.joinable() && !is_on_; }
    bool take_end();  ///< once, when the last picture of a stopped recording and the index are written
    Task task();      ///< while it is writing: to cancel gives up what is not written yet
    std::size_t taken() const { return taken_; }
    const std::filesystem::path& folder() const { return folder_; }

    void take(Image picture, std::string what);
    std::string take_fault();  ///< why pictures or their index could not be written, once; the recording is over then

private:
    struct Frame {
        std::size_t number = 0;
        double seconds = 0.0;
        std::string what;
        Image image;
    };
    void run(const std::stop_token& stop);
    std::string write(const Frame& frame);
    bool has_ended();

    std::filesystem::path folder_;
    std::chrono::steady_clock::time_point begun_;
    std::size_t taken_ = 0;
    bool is_on_ = false;
    std::string index_;  ///< of the writing thread

    std::mutex guard_;  ///< of what follows
    std::condition_variable_any filled_;
    std::deque<Frame> waiting_;
    std::size_t waiting_bytes_ = 0, left_out_ = 0;
    std::string fault_;
    bool ended_ = false;
    std::jthread writing_;  ///< last: it ends before what it uses
};

}  // namespace hanei
