#include "ui/panels/background_work.h"

#include "engine/base/stoppable.h"
#include "engine/base/tiles.h"
#include "ui/panels/language.h"

#include <algorithm>
#include <chrono>
#include <exception>
#include <utility>

namespace hanei {

BackgroundWork::~BackgroundWork() { cancel(); }

bool BackgroundWork::is_done(Run& run) {
    const std::scoped_lock lock(run.guard);
    return run.done;
}

void BackgroundWork::sweep() {
    std::erase_if(left_alone_, [](const std::shared_ptr<Run>& run) { return is_done(*run); });
}

void BackgroundWork::start(std::string name, Job job) {
    cancel();
    name_ = std::move(name);
    left_ = {};
    begun_ = std::chrono::steady_clock::now();
    present_ = std::make_shared<Run>();
    Run& run = *present_;
    run.thread = std::jthread([this, &run, job = std::move(job)](const std::stop_token& stop) {
        Finish finish;
        std::string failure;
        try {
            const Stoppable stoppable(stop);
            finish = job({hardware_threads(), stop, &run.progress});
        } catch (const Stopped&) {
            finish = nullptr;
        } catch (const std::exception& fault) {
            failure = fault.what();
        }
        {
            const std::scoped_lock lock(run.guard);
            run.finish = std::move(finish);
            run.failure = std::move(failure);
            run.done = true;
        }
        run.ended.notify_all();
        wake_();
    });
    {
        std::unique_lock lock(run.guard);
        run.ended.wait_for(lock, std::chrono::duration<double>(patience_), [&] { return run.done; });
    }
    follow();
}

void BackgroundWork::cancel() {
    sweep();
    if (!present_) return;
    present_->thread.request_stop();
    left_alone_.push_back(std::exchange(present_, nullptr));
}

void BackgroundWork::follow() {
    sweep();
    if (!present_ || !is_done(*present_)) return;
    const std::shared_ptr<Run> run = std::exchange(present_, nullptr);
    run->thread.join();
    if (!run->failure.empty()) return failed_(run->failure);
    if (run->finish) run->finish();
}

Task BackgroundWork::task() {
    const float fraction = present_->progress.fraction();
    std::string left = left_.text(Stage::idle, fraction);
    const std::chrono::duration<double> passed = std::chrono::steady_clock::now() - begun_;
    if (fraction == 0.0F && passed > std::chrono::seconds(1)) left = say("for {:.0f} s", passed.count());
    return {"file", name_, fraction, left, [this] { cancel(); }};
}

}  // namespace hanei
