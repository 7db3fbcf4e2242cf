#include "ui/panels/live_study.h"

#include "engine/scene/scene_check.h"

#include <algorithm>

namespace hanei {
namespace {

constexpr std::chrono::milliseconds patience{250};  // of a gesture with the study under way

}  // namespace

LiveStudy::LiveStudy(std::function<void()> wake) : job_(std::move(wake)) {}

bool LiveStudy::answers(const Solution& solution) const {
    return solution.settings == wish_.settings && (solution.scene == wish_.scene || *solution.scene == *wish_.scene);
}

bool LiveStudy::fresh() const {
    if (pending_ || wish_.in_gesture || !solution_ || !solution_->complete) return false;
    if (wish_.unshadowed && !(solution_->display && solution_->display->has_unshadowed)) return false;
    if (wish_.shadows && !solution_->shadows) return false;
    return solution_->scene == final_scene_ && answers(*solution_);
}

const Diagnostic* LiveStudy::fault() const { return has_errors(findings_) ? &findings_.front() : nullptr; }

void LiveStudy::take() {
    if (const std::string failure = job_.take_failure(); !failure.empty()) {
        Diagnostic fault;
        fault.message = "the study could not be finished (" + failure + "); take wider patches";
        findings_.insert(findings_.begin(), std::move(fault));
    }
    SolutionSnapshot taken = job_.take();
    if (!taken) return;
    if (taken->complete) answer_ = taken;
    // A result on the way has no display of its own until direct light is known.
    if (!taken->display && solution_ && solution_->display) return;
    solution_ = std::move(taken);
    if (fresh()) answer_seconds_ = std::chrono::duration<double>(Clock::now() - wished_at_).count();
}

void LiveStudy::start() {
    pending_ = false;
    started_ = true;
    started_at_ = Clock::now();
    findings_ = check_scene(*wish_.scene);
    std::stable_sort(findings_.begin(), findings_.end(),
                     [](const Diagnostic& a, const Diagnostic& b) { return a.severity > b.severity; });
    if (fault() != nullptr) return job_.cancel();
    if (!wish_.in_gesture) final_scene_ = wish_.scene;
    job_.start(
        wish_.scene, wish_.settings,
        {.display = true, .unshadowed = wish_.unshadowed, .shadows = wish_.shadows, .mesh_error = !wish_.in_gesture});
}

void LiveStudy::follow(const Wish& wish) {
    take();
    const bool same_scene = wish_.scene && (wish.scene == wish_.scene || *wish.scene == *wish_.scene);
    const bool more = (wish.unshadowed && !wish_.unshadowed) || (wish.shadows && !wish_.shadows);
    const bool released = wish_.in_gesture && !wish.in_gesture;
    if (!same_scene || wish.settings != wish_.settings || more || released) {
        pending_ = true;
        wished_at_ = Clock::now();
        answer_seconds_ = -1.0;
    }
    const bool unshadowed = wish.unshadowed || (wish_.unshadowed && same_scene);
    const bool shadows = wish.shadows || (wish_.shadows && same_scene);
    wish_ = wish;
    wish_.unshadowed = unshadowed;
    wish_.shadows = shadows;
    if (!pending_) return;
    const bool patient = wish_.in_gesture && started_ && job_.busy() && Clock::now() - started_at_ < patience;
    if (!patient) start();
}

std::string_view name_of(Stage stage) {
    switch (stage) {
        case Stage::idle:
            return "idle";
        case Stage::planning:
            return "planning";
        case Stage::meshing:
            return "cutting patches";
        case Stage::direct:
            return "direct light";
        case Stage::factors:
            return "form factors";
        case Stage::balance:
            return "interreflection";
        case Stage::gathering:
            return "gathering";
        case Stage::refining:
            return "refining the picture";
        case Stage::done:
            return "done";
    }
    return {};
}

}  // namespace hanei
