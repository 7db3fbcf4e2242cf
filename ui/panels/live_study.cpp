#include "ui/panels/live_study.h"

#include "engine/scene/scene_check.h"
#include "ui/panels/language.h"

#include <algorithm>

namespace hanei {
namespace {

constexpr double patience = 1.0;  // s, of a gesture with the study under way

double seconds_since(std::chrono::steady_clock::time_point then) {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - then).count();
}

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

double LiveStudy::answer_age() const { return answer_ ? seconds_since(answered_at_) : -1.0; }

const Diagnostic* LiveStudy::fault() const { return has_errors(findings_) ? &findings_.front() : nullptr; }

void LiveStudy::take() {
    if (const std::string failure = job_.take_failure(); !failure.empty()) {
        Diagnostic fault;
        fault.message = say("the study could not be finished ({}); take wider patches", failure);
        findings_.insert(findings_.begin(), std::move(fault));
    }
    SolutionSnapshot taken = job_.take();
    if (!taken) return;
    if (taken->complete && taken->scene == started_scene_)
        answer_delay_ = {answer_delay_.count + 1, seconds_since(started_wish_at_)};
    if (taken->complete) {
        answer_ = taken;
        answered_at_ = Clock::now();
        if (wish_.in_gesture) expected_seconds_ = seconds_since(started_at_);
    }
    // A result on the way has no display of its own until direct light is known.
    if (!taken->display && solution_ && solution_->display) return;
    solution_ = std::move(taken);
    if (!is_pictured_ && solution_->scene == started_scene_) {
        picture_delay_ = {picture_delay_.count + 1, seconds_since(started_wish_at_)};
        is_pictured_ = true;
    }
    if (fresh()) answer_seconds_ = seconds_since(wished_at_);
}

void LiveStudy::cancel() {
    job_.cancel();
    cancelled_ = true;
}

bool LiveStudy::is_cancellable() const {
    constexpr double a_while = 0.5;  // s
    return !wish_.in_gesture && !pending_ && !cancelled_ && started_ && job_.busy() &&
           seconds_since(started_at_) > a_while;
}

void LiveStudy::start() {
    pending_ = cancelled_ = false;
    started_ = true;
    started_at_ = Clock::now();
    findings_ = check_scene(*wish_.scene);
    std::stable_sort(findings_.begin(), findings_.end(),
                     [](const Diagnostic& a, const Diagnostic& b) { return a.severity > b.severity; });
    if (fault() != nullptr) return job_.cancel();
    if (!wish_.in_gesture) final_scene_ = wish_.scene;
    started_scene_ = wish_.scene;
    started_wish_at_ = wished_at_;
    is_pictured_ = false;
    job_.start(wish_.scene, wish_.settings,
               {.display = true,
                .unshadowed = wish_.unshadowed,
                .shadows = wish_.shadows,
                .live = wish_.in_gesture,
                .energy = !wish_.in_gesture,
                .mesh_error = !wish_.in_gesture});
}

/// Whether the study under way is worth waiting for, though the scene has gone on.
bool LiveStudy::is_patient() const {
    if (!wish_.in_gesture || !started_ || !job_.busy()) return false;
    const bool is_slow = expected_seconds_ > patience;
    return seconds_since(started_at_) < patience && !(is_slow && is_pictured_);
}

void LiveStudy::follow(const Wish& wish) {
    take();
    const bool same_scene = wish_.scene && (wish.scene == wish_.scene || *wish.scene == *wish_.scene);
    const bool more = (wish.unshadowed && !wish_.unshadowed) || (wish.shadows && !wish_.shadows);
    const bool released = wish_.in_gesture && !wish.in_gesture;
    if (released) expected_seconds_ = 0.0;
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
    if (is_patient()) return;
    if (wish_.in_gesture && job_.busy())
        expected_seconds_ = std::max(expected_seconds_, 2.0 * seconds_since(started_at_));
    start();
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

std::shared_ptr<const Contributions> LiveStudy::contributions(const Vec3& position, const Vec3& normal) {
    if (auto made = job_.take_contributions()) contributions_ = std::move(made);
    const bool asked = asked_.solution == answer_ && asked_.position == position && asked_.normal == normal;
    if (answer_ && fresh() && !asked) {
        asked_ = {answer_, position, normal};
        job_.ask(asked_);
    }
    const bool of_it = contributions_ && contributions_->position == position && contributions_->normal == normal;
    return of_it ? contributions_ : nullptr;
}

}  // namespace hanei
