#include "engine/study/job.h"

#include "engine/base/stand_back.h"

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
    question_.reset();
    running_.request_stop();
}

void Job::ask(Question question) {
    {
        const std::scoped_lock lock(guard_);
        question_ = std::move(question);
        if (!is_running_) running_.request_stop();  // the question before
    }
    arrived_.notify_one();
}

std::shared_ptr<const Contributions> Job::take_contributions() {
    const std::scoped_lock lock(guard_);
    return std::exchange(contributions_, nullptr);
}

void Job::answer(Study& study, const Question& question, const std::stop_token& stop) {
    auto made = study.contributions(question.solution, question.position, question.normal, Work{1, stop, nullptr});
    if (!made) return;
    // what was asked about, although it may have been computed anew
    made->solution = question.solution;
    const std::scoped_lock lock(guard_);
    contributions_ = std::make_shared<const Contributions>(std::move(*made));
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

/// The window's own thread draws: it goes first.
void Job::serve(const std::stop_token& end) {
    stand_back();
    Study study;
    while (true) {
        std::optional<Request> request;
        std::optional<Question> question;
        Work work{.progress = &progress_};
        {
            std::unique_lock lock(guard_);
            is_running_ = false;
            if (!arrived_.wait(lock, end, [&] { return waiting_.has_value() || question_.has_value(); })) return;
            if (waiting_)
                request = std::exchange(waiting_, std::nullopt);
            else
                question = std::exchange(question_, std::nullopt);
            running_ = std::stop_source();
            is_running_ = request.has_value();
            work.stop = running_.get_token();
        }
        try {
            if (question) answer(study, *question, work.stop);
            const auto on_the_way = [this](SolutionSnapshot part) { post(std::move(part)); };
            if (!request) {
                wake_();
                continue;
            }
            if (auto solution = study.run(request->scene, request->settings, request->wanted, work, on_the_way))
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
