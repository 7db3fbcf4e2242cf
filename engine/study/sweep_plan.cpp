#include "engine/study/sweep_plan.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace hanei {
namespace {

constexpr std::array few{10, 4, 2, 1};
constexpr int bounces_of_the_paper = 4;
constexpr int converged = 1000;

/// Of a linear patch with its four unknowns, so that methods have about as many.
double width_of(Method method, double width) { return method == Method::linear ? 2.0 * width : width; }

std::vector<int> fewer_than(int most) {
    std::vector<int> fewer;
    for (const int bounces : few)
        if (bounces < most) fewer.push_back(bounces);
    return fewer;
}

void add_bounces(PlannedRun& run, int bounces) {
    const bool there = std::find(run.fewer.begin(), run.fewer.end(), bounces) != run.fewer.end();
    if (there || bounces >= run.settings.bounces) return;
    run.fewer.push_back(bounces);
    std::sort(run.fewer.rbegin(), run.fewer.rend());
}

bool is_of(const PlannedRun& run, const Settings& settings) {
    return run.shadows && !run.preset && run.settings.method == settings.method &&
           run.settings.max_patch == settings.max_patch;
}

PlannedRun with_prediction(const Scene& scene, PlannedRun run, const Calibration& calibration) {
    run.predicted = calibration.predict(scene, run.settings);
    return run;
}

}  // namespace

int all_bounces(Method method) { return method == Method::paper ? few.front() : converged; }

std::vector<PlannedRun> planned_runs(const Scene& scene, const Settings& settings, const Calibration& calibration,
                                     bool something_between) {
    constexpr double widths[] = {4.0, 2.0, 1.0, 0.5};  // times the patch width set
    std::vector<PlannedRun> runs;
    const auto add = [&](Method method, double width, bool shadows) {
        PlannedRun run;
        run.settings = settings;
        run.settings.method = method;
        run.settings.max_patch = width;
        run.settings.bounces = all_bounces(method);
        run.shadows = shadows;
        run.fewer = fewer_than(run.settings.bounces);
        runs.push_back(with_prediction(scene, std::move(run), calibration));
    };
    for (const bool shadows : {true, false})
        for (const Method method : methods)
            for (const double width : widths)
                if (shadows || something_between) add(method, width_of(method, width * settings.max_patch), shadows);

    Settings own = settings;
    own.method = Method::paper;
    for (const Settings& wanted : {settings, own}) {
        auto run = std::find_if(runs.begin(), runs.end(), [&](const PlannedRun& each) { return is_of(each, wanted); });
        if (run == runs.end()) {
            add(wanted.method, wanted.max_patch, true);
            run = runs.end() - 1;
        }
        run->wanted = true;
        add_bounces(*run, wanted.bounces);
    }
    for (const Preset preset : presets) {
        const Suggestion suggestion = settings_for(scene, settings, preset, calibration);
        PlannedRun run;
        run.settings = suggestion.settings;
        run.predicted = suggestion.prediction;
        run.preset = preset;
        run.wanted = true;
        runs.push_back(std::move(run));
    }
    std::stable_sort(runs.begin(), runs.end(), [](const PlannedRun& a, const PlannedRun& b) {
        return a.wanted != b.wanted ? a.wanted : a.predicted.ms < b.predicted.ms;
    });
    return runs;
}

SweepMarks marks_of(const PlannedRun& run, int bounces, const Settings& present) {
    SweepMarks marks;
    if (run.preset) {
        if (bounces == run.settings.bounces) marks.preset = run.preset;
        return marks;
    }
    marks.current = is_of(run, present) && bounces == std::min(present.bounces, run.settings.bounces);
    Settings own = present;
    own.method = Method::paper;
    marks.paper = is_of(run, own) && bounces == bounces_of_the_paper;
    return marks;
}

std::optional<Settings> finest_within(const Scene& scene, const Settings& settings, Method method, double ms,
                                      const Calibration& calibration) {
    constexpr int steps_wider = 8, steps_finer = 4;
    Settings fine = settings;
    fine.method = method;
    fine.bounces = std::max(settings.bounces, converged);
    fine.accuracy = std::min(settings.accuracy, 1e-5);
    fine.tolerance_lux = 0.0;
    for (int step = -steps_finer; step <= steps_wider; ++step) {
        fine.max_patch = settings.max_patch * std::pow(2.0, 0.5 * step);
        if (calibration.predict(scene, fine).ms <= ms) return fine;
    }
    return std::nullopt;
}

}  // namespace hanei
