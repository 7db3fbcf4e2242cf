#include "app/calibration_file.h"
#include "app/commands.h"
#include "app/exit_code.h"
#include "app/files.h"
#include "app/light_commands.h"
#include "app/photometry_command.h"
#include "engine/base/tiles.h"
#include "engine/project/measured_file.h"
#include "engine/report/effect_trials_report.h"
#include "engine/report/measured_report.h"
#include "engine/report/report.h"
#include "engine/report/report_json.h"
#include "engine/report/sweep_report.h"
#include "engine/scene/hard_spots.h"
#include "engine/scene/scene_check.h"
#include "engine/study/presets.h"
#include "engine/study/study.h"

#include <cstdio>
#include <nlohmann/json.hpp>

namespace hanei {

namespace {

/// Read first: a study is not waited for to learn that the table cannot be used.
bool read_others(const SolveRequest& request, MeasuredValues& values) {
    if (!request.compared_with) return true;
    MeasuredRead read = read_measured(*request.compared_with);
    print_findings(read.findings);
    if (!read.values) return false;
    values = std::move(*read.values);
    return true;
}

/// What is written of the solution, with the comparison in it.
std::string json_with(const std::string& solution, const MeasuredComparison& comparison) {
    nlohmann::ordered_json json = nlohmann::ordered_json::parse(solution);
    json["compared"] = nlohmann::ordered_json::parse(measured_json(comparison));
    return json.dump(2) + '\n';
}

/// Chooses what the wish asks for; other options that are given have the last word.
void choose_settings(const SolveRequest& request, const Scene& scene, Settings& settings) {
    const auto preset = preset_named(request.preset);
    if (!preset && !(request.within > 0.0)) return;
    const double wish = preset ? wished_error(*preset) : 0.01 * request.within;
    const Calibration calibration = known_calibration();
    const Suggestion suggestion = settings_for(scene, settings, wish, calibration);
    settings = suggestion.settings;
    request.change(settings);
    const Prediction prediction =
        settings == suggestion.settings ? suggestion.prediction : calibration.predict(scene, settings);
    std::fprintf(stderr,
                 "%s %.3g %%: --method %s --max-patch %.3g --bounces %d --accuracy %.3g; predicted %s, and 95 of 100 "
                 "points within %s (%s)%s\n",
                 preset ? request.preset.c_str() : "within", 100.0 * wish,
                 std::string(name_of(settings.method)).c_str(), settings.max_patch, settings.bounces,
                 100.0 * settings.accuracy, time_text(prediction.ms).c_str(), percent_text(prediction.error).c_str(),
                 basis_of(prediction).c_str(), suggestion.reaches ? "" : "; nothing is predicted to reach it");
}

}  // namespace

int solve_command(const SolveRequest& request) {
    MeasuredValues others;
    if (!read_others(request, others)) return exit_bad_input;
    auto project = open_project(request.project);
    if (!project) return exit_bad_input;
    if (!recall_light_scene(project->scene, request.light_scene, request.project)) return exit_bad_input;
    request.change(project->settings);
    choose_settings(request, project->scene, project->settings);
    const auto scene = std::make_shared<const Scene>(std::move(project->scene));
    Study study;
    const SolutionSnapshot solution = study.run(scene, project->settings, StudyRequest{.energy = true}, Work{});
    std::fputs(summary_text(*solution).c_str(), stdout);
    if (request.csv) write_text(*request.csv, values_csv(*solution));
    MeasuredComparison comparison;
    if (request.compared_with) {
        comparison = compared_with(*solution, others);
        print_findings(comparison.faults);
        if (!comparison.faults.empty()) return exit_bad_input;
        std::printf("\n%s", measured_text(comparison).c_str());
        if (request.differences) write_text(*request.differences, measured_csv(comparison));
    }
    const std::string json = values_json(*solution);
    if (request.json) write_text(*request.json, request.compared_with ? json_with(json, comparison) : json);
    if (solution->refusal.empty()) return exit_done;
    std::fprintf(stderr, "%s: %s\n", request.project.c_str(), solution->refusal.c_str());
    return exit_answer_is_no;
}

int plan_command(const PlanRequest& request) {
    auto project = open_project(request.project);
    if (!project) return exit_bad_input;
    request.change(project->settings);
    const EffectsPlan plan = plan_effects(project->scene, project->settings);
    std::fputs(plan_text(plan).c_str(), stdout);
    if (!request.measure) {
        if (request.json) write_text(*request.json, plan_json(plan));
        return exit_done;
    }
    const int threads = project->settings.threads > 0 ? project->settings.threads : hardware_threads();
    const auto scene = std::make_shared<const Scene>(std::move(project->scene));
    const auto trials = try_effects(scene, project->settings, Work{threads});
    std::fputs(trials_text(*trials).c_str(), stdout);
    if (request.json) write_text(*request.json, plan_json(plan, *trials));
    return exit_done;
}

int check_command(const std::filesystem::path& project) {
    ProjectRead read = read_project(project);
    if (read.project) {
        const Diagnostics found = photometry_findings(read.project->scene, project.string(), read.findings);
        read.findings.insert(read.findings.end(), found.begin(), found.end());
    }
    print_findings(read.findings);
    if (!read.project) return exit_bad_input;
    Diagnostics all = hard_spots(read.project->scene);
    for (const Diagnostic& spot : all)
        std::printf("%s: %s: note: %s\n", project.c_str(), spot.place.field.c_str(), spot.message.c_str());
    all.insert(all.end(), read.findings.begin(), read.findings.end());
    std::printf("%s: %s\n", project.c_str(), verdict_of(all).c_str());
    return read.findings.empty() ? exit_done : exit_answer_is_no;
}

}  // namespace hanei
