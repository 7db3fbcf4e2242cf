/// Ctrl+C while a command computes: the work is stopped first, then the program ends as it would have.
#pragma once

#include <atomic>
#include <csignal>
#include <stop_token>
#include <thread>

namespace hanei {

/// While it lives, SIGINT and SIGTERM ask for a stop in place of ending the program at once, so
/// that nothing is left half written. Signals that were ignored stay ignored.
///
/// Needs     to be made before the threads that compute, on the thread that makes them; one at a time.
class Interrupt {
public:
    Interrupt();
    ~Interrupt();
    Interrupt(const Interrupt&) = delete;
    Interrupt& operator=(const Interrupt&) = delete;

    std::stop_token token() const { return wish_.get_token(); }
    bool came() const { return wish_.stop_requested(); }

    /// Ends the program by the signal that came, as whoever started it expects. Call it when
    /// everything is put away.
    void pass_on();

private:
    void wait(const std::stop_token& end);
    void release();

    sigset_t watched_ = {};
    sigset_t before_ = {};
    std::atomic<int> signal_ = 0;
    std::stop_source wish_;
    std::jthread waiting_;  ///< last: it ends before what it uses
};

}  // namespace hanei
