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
    ~FrameRecording() { stop(); }

    /// Into a new folder "NAME recording 2026-11-22 15-04-05" there. Returns why it cannot be, or nothing.
    std::optional<std::string> start(const std::filesystem::path& where, const std::string& name);
    void stop();  ///< what waits is written first, in the background no more: seconds at most
    bool is_on() const { return writing_.joinable(); }
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

    std::filesystem::path folder_;
    std::chrono::steady_clock::time_point begun_;
    std::size_t taken_ = 0;
    std::string index_;  ///< of the writing thread

    std::mutex guard_;  ///< of what follows
    std::condition_variable_any filled_;
    std::deque<Frame> waiting_;
    std::size_t waiting_bytes_ = 0, left_out_ = 0;
    std::string fault_;
    std::jthread writing_;  ///< last: it ends before what it uses
};

}  // namespace hanei
