#include "app/interrupt.h"

#include <ctime>

namespace hanei {

Interrupt::Interrupt() {
    sigemptyset(&watched_);
    for (const int number : {SIGINT, SIGTERM}) {
        struct sigaction present = {};
        sigaction(number, nullptr, &present);
        if (present.sa_handler != SIG_IGN) sigaddset(&watched_, number);
    }
    pthread_sigmask(SIG_BLOCK, &watched_, &before_);
    waiting_ = std::jthread([this](const std::stop_token& end) { wait(end); });
}

Interrupt::~Interrupt() { release(); }

void Interrupt::release() {
    waiting_.request_stop();
    if (!waiting_.joinable()) return;
    waiting_.join();
    pthread_sigmask(SIG_SETMASK, &before_, nullptr);
}

void Interrupt::wait(const std::stop_token& end) {
    constexpr timespec patience{0, 50'000'000};  // ns: how soon it notices that it is no longer needed
    while (!end.stop_requested()) {
        const int number = sigtimedwait(&watched_, nullptr, &patience);
        if (number <= 0) continue;
        signal_ = number;
        wish_.request_stop();
        return;
    }
}

void Interrupt::pass_on() {
    release();
    if (signal_ == 0) return;
    std::signal(signal_, SIG_DFL);
    std::raise(signal_);
}

}  // namespace hanei
