#include "ui/panels/autosave.h"

#include <algorithm>
#include <utility>

namespace hanei {
namespace {

constexpr std::chrono::seconds least_pause{1};
constexpr std::chrono::seconds pause_after_fault{5};
constexpr int pause_over_work = 9;  // keeping takes a tenth of the time at most

}  // namespace

Autosave::Autosave(RecoveryDoor door, std::function<void()> wake) : door_(std::move(door)), wake_(std::move(wake)) {
    if (door_.keep) thread_ = std::jthread([this](const std::stop_token& stop) { run(stop); });
}

Autosave::~Autosave() {
    if (!thread_.joinable()) return;
    thread_.request_stop();
    thread_.join();
    if (waiting_) keep(*std::exchange(waiting_, std::nullopt));
}

void Autosave::follow(const Document& document, double interval_seconds) {
    if (!door_.keep) return;
    if (document.is_saved()) {
        if (handed_) hand_over(std::nullopt, interval_seconds);
        return;
    }
    const bool known = handed_ && handed_->scene == document.shown() && handed_->settings == document.settings() &&
                       handed_->original == document.file() && handed_->in_step == document.in_gesture();
    if (!known)
        hand_over(Work{document.shown(), document.settings(), document.file(), document.in_gesture()},
                  interval_seconds);
}

void Autosave::hand_over(std::optional<Work> work, double interval_seconds) {
    const bool begins = !handed_;
    handed_ = work;
    const std::scoped_lock lock(guard_);
    const bool waited = waiting_.has_value();
    const bool in_step = waited && waiting_->in_step;
    interval_ = std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(interval_seconds));
    if (begins && work && work->in_step) last_kept_ = Clock::now();  // up to here all was saved
    forgets_ = !work;
    waiting_ = std::move(work);
    if (forgets_ || !waited || in_step != waiting_->in_step) told_.notify_all();
}

void Autosave::end() {
    if (!thread_.joinable()) return;
    thread_.request_stop();
    thread_.join();
    waiting_.reset();
    door_.forget();
    for (const LostWork& work : taken_over_) door_.discard(work);
    taken_over_.clear();
}

void Autosave::take_over(LostWork work) {
    const std::scoped_lock lock(guard_);
    taken_over_.push_back(std::move(work));
}

std::optional<Diagnostic> Autosave::take_fault() {
    const std::scoped_lock lock(guard_);
    return std::exchange(fault_, std::nullopt);
}

void Autosave::run(const std::stop_token& stop) {
    std::unique_lock lock(guard_);
    while (!stop.stop_requested()) {
        told_.wait(lock, stop, [this] { return waiting_ || forgets_; });
        if (stop.stop_requested()) return;
        if (forgets_) {
            forgets_ = false;
            lock.unlock();
            door_.forget();
            lock.lock();
            continue;
        }
        const bool in_step = waiting_->in_step;
        const Clock::duration pause =
            refused_.empty() ? (in_step ? interval_ : std::max<Clock::duration>(least_pause, pause_over_work * took_))
                             : pause_after_fault;
        const bool other = told_.wait_until(lock, stop, last_kept_ + pause,
                                            [&] { return forgets_ || !waiting_ || waiting_->in_step != in_step; });
        if (stop.stop_requested()) return;
        if (other) continue;
        const Work work = *std::exchange(waiting_, std::nullopt);
        lock.unlock();
        keep(work);
        lock.lock();
    }
}

void Autosave::keep(const Work& work) {
    const Clock::time_point begun = Clock::now();
    const std::optional<Diagnostic> fault = door_.keep(*work.scene, work.settings, work.original);
    std::vector<LostWork> taken_over;
    {
        const std::scoped_lock lock(guard_);
        last_kept_ = Clock::now();
        took_ = last_kept_ - begun;
        if (fault) {
            if (fault->message != refused_) fault_ = fault;
            if (!waiting_ && !forgets_) waiting_ = work;
        } else {
            taken_over.swap(taken_over_);
        }
        refused_ = fault ? fault->message : std::string();
    }
    for (const LostWork& other : taken_over) door_.discard(other);
    if (fault) wake_();
}

}  // namespace hanei
