/// A wish to stop that comes by itself after a while.
#pragma once

#include <chrono>
#include <condition_variable>
#include <functional>
#include <mutex>
#include <stop_token>
#include <thread>

namespace hanei {

/// Stops what is given its token when `seconds` have passed, or when the token it was made with stops.
class Deadline {
public:
    Deadline(double seconds, const std::stop_token& outer)
        : passed_on_(outer, [this] { source_.request_stop(); }), waiting_([this, seconds](const std::stop_token& end) {
              std::unique_lock lock(guard_);
              woken_.wait_for(lock, end, std::chrono::duration<double>(seconds), [] { return false; });
              if (!end.stop_requested()) source_.request_stop();
          }) {}

    std::stop_token token() const { return source_.get_token(); }

private:
    std::stop_source source_;
    std::stop_callback<std::function<void()>> passed_on_;
    std::mutex guard_;
    std::condition_variable_any woken_;
    std::jthread waiting_;  ///< last: it ends before what it uses
};

}  // namespace hanei
