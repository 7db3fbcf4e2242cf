#include "app/commands.h"
#include "app/exit_code.h"
#include "app/files.h"
#include "app/light_commands.h"
#include "app/photometry_command.h"
#include "engine/report/report.h"
#include "engine/report/report_json.h"
#include "engine/scene/scene_check.h"
#include "engine/study/study.h"

#include <cstdio>

namespace hanei {

int solve_command(const SolveRequest& request) {
    auto project = open_project(request.project);
    if (!project) return exit_bad_input;
    if (!recall_light_scene(project->scene, request.light_scene, request.project)) return exit_bad_input;
    request.change(project->settings);
    const auto scene = std::make_shared<const Scene>(std::move(project->scene));
    Study study;
    const SolutionSnapshot solution = study.run(scene, project->settings, StudyRequest{.energy = true}, Work{});
    std::fputs(summary_text(*solution).c_str(), stdout);
    if (request.csv) write_text(*request.csv, values_csv(*solution));
    if (request.json) write_text(*request.json, values_json(*solution));
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
    if (request.json) write_text(*request.json, plan_json(plan));
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
    if (read.findings.empty()) {
        std::printf("%s: nothing to complain about\n", project.c_str());
        return exit_done;
    }
    return exit_answer_is_no;
}

}  // namespace hanei
