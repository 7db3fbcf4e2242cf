#include "engine/study/job.h"

#include <exception>

namespace hanei {

Job::Job(std::function<void()> wake)
    : wake_(std::move(wake)), thread_([this](const std::stop_token& end) { serve(end); }) {}

Job::~Job() {
    cancel();
    thread_.request_stop();
}

void Job::start(SceneSnapshot scene, const Settings& settings, const StudyRequest& request) {
    {
        const std::scoped_lock lock(guard_);
        waiting_ = Request{std::move(scene), settings, request};
        running_.request_stop();
    }
    arrived_.notify_one();
}

void Job::cancel() {
    const std::scoped_lock lock(guard_);
    waiting_.reset();
    running_.request_stop();
}

SolutionSnapshot Job::take() {
    const std::scoped_lock lock(guard_);
    return std::exchange(finished_, nullptr);
}

bool Job::busy() const {
    const std::scoped_lock lock(guard_);
    return is_running_ || waiting_.has_value();
}

std::string Job::take_failure() {
    const std::scoped_lock lock(guard_);
    return std::exchange(failure_, {});
}

void Job::post(SolutionSnapshot solution) {
    {
        const std::scoped_lock lock(guard_);
        if (!running_.stop_requested()) finished_ = std::move(solution);
    }
    wake_();
}

void Job::serve(const std::stop_token& end) {
    Study study;
    while (true) {
        Request request;
        Work work{.progress = &progress_};
        {
            std::unique_lock lock(guard_);
            is_running_ = false;
            if (!arrived_.wait(lock, end, [&] { return waiting_.has_value(); })) return;
            request = std::move(*waiting_);
            waiting_.reset();
            running_ = std::stop_source();
            is_running_ = true;
            work.stop = running_.get_token();
        }
        try {
            const auto on_the_way = [this](SolutionSnapshot part) { post(std::move(part)); };
            if (auto solution = study.run(request.scene, request.settings, request.wanted, work, on_the_way))
                post(std::move(solution));
        } catch (const std::exception& failure) {
            const std::scoped_lock lock(guard_);
            failure_ = failure.what();
        }
        {
            const std::scoped_lock lock(guard_);
            is_running_ = false;
        }
        progress_.enter(Stage::idle);
        wake_();
    }
}

}  // namespace hanei
