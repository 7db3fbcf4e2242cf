#include "engine/study/sweep.h"

#include "engine/plan/places.h"
#include "engine/study/deadline.h"
#include "engine/study/frontier.h"
#include "engine/study/study.h"
#include "engine/study/sweep_plan.h"
#include "engine/study/sweep_run.h"

#include <algorithm>
#include <chrono>
#include <ctime>
#include <fmt/format.h>

namespace hanei {

namespace {

using Clock = std::chrono::steady_clock;

/// One sweep on its way.
class Sweeping {
public:
    Sweeping(const SceneSnapshot& scene, const Settings& settings, const SweepWish& wish, const Work& work)
        : scene_(scene),
          settings_(settings),
          wish_(wish),
          work_{work.threads, work.stop, nullptr},
          progress_(work.progress),
          known_(wish.calibration) {
        if (wish.expected) sets_ = wish.expected->sets;
    }

    Sweep run();

private:
    bool find_truth();
    bool take_expected();
    bool warm_up();
    std::optional<Settings> finest(Method method, double share) const;
    std::optional<SweepAnswer> compared_with(const Settings& fine, double most_seconds);
    static std::string run_words(const Settings& settings, const SweepAnswer& answer);
    bool carry_out(const PlannedRun& planned);
    std::optional<SweepAnswer> timed(const PlannedRun& planned, std::optional<SweepRun>& run, const Work& work);
    void note(const PlannedRun& planned, const SweepAnswer& answer, int bounces, double ms);
    void learn(const PlannedRun& planned, const SweepAnswer& answer);
    void leave_out(const PlannedRun& planned, double ms);
    void find_frontier();
    void tell();

    double seconds() const { return std::chrono::duration<double>(Clock::now() - begun_).count(); }
    double left_ms() const { return 1000.0 * (wish_.budget - seconds()); }

    SceneSnapshot scene_;
    Settings settings_;
    const SweepWish& wish_;
    Work work_;              ///< of the runs: without progress, which each would begin anew
    Progress* progress_;     ///< of all of them
    Calibration known_;      ///< with what the runs so far taught
    double slowness_ = 1.0;  ///< of this room on this machine, over what was expected
    std::vector<std::string> sets_;
    std::vector<ComparedValue> truth_;
    Sweep sweep_;
    Clock::time_point begun_ = Clock::now();
    std::clock_t processor_ = std::clock();
};

void Sweeping::tell() {
    sweep_.spent_s = seconds();
    sweep_.processor_s = static_cast<double>(std::clock() - processor_) / CLOCKS_PER_SEC;
    if (progress_) progress_->advance(static_cast<float>(std::min(1.0, sweep_.spent_s / wish_.budget)));
    if (wish_.on_way) wish_.on_way(sweep_);
}

bool Sweeping::take_expected() {
    const SweepExpected& expected = *wish_.expected;
    sweep_.against = expected.source;
    sweep_.lumen.refusal = "a reference case is compared point by point";
    for (std::size_t k = 0; k < expected.lux.size(); ++k) truth_.push_back({expected.lux[k], expected.sets[k]});
    std::vector<ComparedValue> off = truth_;
    for (std::size_t k = 0; k < std::min(off.size(), expected.uncertainty.size()); ++k)
        off[k].lux += expected.uncertainty[k];
    sweep_.uncertainty = errors_by_set(off, truth_).front();
    sweep_.uncertainty_words = "as the case states it";
    return true;
}

/// A coarse run tells what this room takes on this machine as busy as it is.
bool Sweeping::warm_up() {
    Settings coarse = settings_;
    coarse.method = Method::patch;
    coarse.bounces = all_bounces(Method::patch);
    coarse.max_patch = 2.0 * settings_.max_patch;
    const double expected = known_.predict(*scene_, coarse).ms;
    const auto answer = compared_with(coarse, wish_.budget);
    if (answer && expected > 0.0) slowness_ = std::clamp(answer->milliseconds / expected, 1.0, 20.0);
    return answer.has_value();
}

/// That takes no more than this share of the budget; of a method that was never studied here it is
/// taken to be as much slower than elsewhere as the coarse run was.
std::optional<Settings> Sweeping::finest(Method method, double share) const {
    Settings of_method = settings_;
    of_method.method = method;
    const bool was_studied = known_.predict(*scene_, of_method).same_room;
    const double ms = share * 1000.0 * wish_.budget / (was_studied ? 1.0 : slowness_);
    return finest_within(*scene_, settings_, method, ms, known_);
}

/// A run that others are compared with; given up when it takes longer than that.
std::optional<SweepAnswer> Sweeping::compared_with(const Settings& fine, double most_seconds) {
    const Deadline deadline(most_seconds, work_.stop);
    SweepRun run(scene_, fine, true, sets_);
    auto answer = run.with_bounces(fine.bounces, {work_.threads, deadline.token(), nullptr});
    if (!answer) return std::nullopt;
    const CalibrationSample sample = sample_of(expected_work(*scene_, fine), fine.method, answer->times);
    known_.learn(sample);
    sweep_.learned.push_back(sample);
    tell();
    return answer;
}

std::string Sweeping::run_words(const Settings& settings, const SweepAnswer& answer) {
    return fmt::format("{}, patches of {:.3g} m, {} unknowns", name_of(settings.method), settings.max_patch,
                       answer.unknowns);
}

bool Sweeping::find_truth() {
    if (wish_.expected) return take_expected();
    constexpr double shares[] = {1.0 / 3.0, 1.0 / 6.0};
    if (!warm_up()) return false;
    std::optional<SweepAnswer> fine, other;
    auto settings = finest(Method::linear, shares[0]);
    if (settings) fine = compared_with(*settings, 1.5 * shares[0] * wish_.budget);
    auto other_settings = finest(Method::patch, shares[1]);
    std::string kind = "of another kind and width";
    if (!fine && !work_.stop.stop_requested()) {
        settings = finest(Method::patch, shares[1]);
        if (settings) fine = compared_with(*settings, wish_.budget);
        other_settings = settings;
        if (other_settings) other_settings->max_patch *= 2.0;
        kind = "with patches twice as wide";
    }
    if (fine && other_settings) other = compared_with(*other_settings, wish_.budget);
    if (!fine || !other) return false;
    sweep_.against = fmt::format("the finest run ({})", run_words(*settings, *fine));
    sweep_.uncertainty_words =
        fmt::format("its difference from a run {} ({})", kind, run_words(*other_settings, *other));
    truth_ = fine->values;
    sweep_.uncertainty = errors_by_set(other->values, truth_).front();
    sweep_.lumen = lumen_point(*fine->solution);
    return true;
}

/// Short runs are repeated, so that what else the machine does hardly counts. `run` is the last one, when it ended.
std::optional<SweepAnswer> Sweeping::timed(const PlannedRun& planned, std::optional<SweepRun>& run, const Work& work) {
    constexpr int most_runs = 5;
    const double long_enough = std::clamp(1000.0 * wish_.budget / 300.0, 5.0, 400.0);  // ms
    std::optional<SweepAnswer> best;
    double spent = 0.0;
    for (int k = 0; k < most_runs && spent < long_enough; ++k) {
        run.emplace(scene_, planned.settings, planned.shadows, sets_);  // a new one: nothing is reused
        auto answer = run->with_bounces(planned.settings.bounces, work);
        if (!answer) {
            run.reset();
            break;
        }
        spent += answer->milliseconds;
        if (!best || answer->milliseconds < best->milliseconds) best = std::move(answer);
    }
    return best;
}

void Sweeping::note(const PlannedRun& planned, const SweepAnswer& answer, int bounces, double ms) {
    SweepPoint& point = sweep_.points.emplace_back();
    point.settings = planned.settings;
    point.settings.bounces = bounces;
    point.shadows = planned.shadows;
    point.complete = bounces == planned.settings.bounces;
    point.marks = marks_of(planned, bounces, settings_);
    point.unknowns = answer.unknowns;
    point.milliseconds = ms;
    point.predicted = planned.predicted;
    point.errors = errors_by_set(answer.values, truth_);
}

void Sweeping::learn(const PlannedRun& planned, const SweepAnswer& answer) {
    if (!planned.shadows) return;
    CalibrationSample sample =
        sample_of(expected_work(*scene_, planned.settings), planned.settings.method, answer.times);
    const SweepErrors& error = sweep_.points.back().errors.front();
    sample.error = std::max(error.p95, sweep_.uncertainty.p95);
    known_.learn(sample);
    sweep_.learned.push_back(sample);
}

void Sweeping::leave_out(const PlannedRun& planned, double ms) {
    sweep_.left_out.push_back({planned.settings, planned.shadows, ms});
}

bool Sweeping::carry_out(const PlannedRun& planned) {
    const double predicted = known_.predict(*scene_, planned.settings).ms;
    if (predicted > left_ms()) {
        leave_out(planned, predicted);
        return true;
    }
    const double left = left_ms();  // a prediction that was too good takes no more
    const Deadline deadline(1e-3 * left, work_.stop);
    const Work work{work_.threads, deadline.token(), nullptr};
    std::optional<SweepRun> run;
    const auto whole = timed(planned, run, work);
    if (work_.stop.stop_requested()) return false;
    if (!whole) {
        leave_out(planned, left);
        return true;
    }
    note(planned, *whole, planned.settings.bounces, whole->milliseconds);
    learn(planned, *whole);
    for (const int bounces : planned.fewer) {
        const auto answer = run ? run->with_bounces(bounces, work) : std::nullopt;
        if (!answer) break;
        note(planned, *answer, bounces, whole->milliseconds - whole->balance_ms() + answer->balance_ms());
    }
    find_frontier();
    tell();
    return true;
}

void Sweeping::find_frontier() {
    constexpr double alike = 0.04;  // of two times: what else the machine does
    std::vector<CostAndError> ways;
    for (SweepPoint& point : sweep_.points) {
        point.on_frontier = false;
        ways.push_back({point.milliseconds, point.errors.front().p95});
    }
    for (const std::size_t k : pareto_frontier(ways, sweep_.uncertainty.p95, alike))
        sweep_.points[k].on_frontier = true;
}

Sweep Sweeping::run() {
    if (progress_) progress_->enter(Stage::gathering);
    sweep_.budget_s = wish_.budget;
    sweep_.something_between = !obstacles_of(*scene_).empty();
    const auto runs = planned_runs(*scene_, settings_, wish_.calibration, sweep_.something_between);
    const bool has_truth = find_truth();
    if (!has_truth)
        for (const PlannedRun& planned : runs) leave_out(planned, planned.predicted.ms);
    bool goes_on = has_truth;
    for (auto planned = runs.begin(); goes_on && planned != runs.end(); ++planned) goes_on = carry_out(*planned);
    sweep_.stopped = work_.stop.stop_requested();
    tell();
    return std::move(sweep_);
}

}  // namespace

Sweep accuracy_sweep(const SceneSnapshot& scene, const Settings& settings, const SweepWish& wish, const Work& work) {
    return Sweeping(scene, settings, wish, work).run();
}

}  // namespace hanei
