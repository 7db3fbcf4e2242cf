#include "app/commands.h"
#include "app/exit_code.h"
#include "app/files.h"
#include "engine/report/sweep_report.h"
#include "engine/study/study.h"

#include <cstdio>
#include <filesystem>

namespace hanei {

int study_command(const SweepRequest& request) {
    auto project = open_project(request.project);
    if (!project) return exit_bad_input;
    request.change(project->settings);
    if (project->scene.points.empty() && project->scene.grids.empty()) {
        std::fprintf(stderr, "%s: there are no calculation grids or points to compare at\n", request.project.c_str());
        return exit_bad_input;
    }
    const auto scene = std::make_shared<const Scene>(std::move(project->scene));
    const auto points = accuracy_sweep(scene, project->settings, Work{});
    std::filesystem::create_directories(request.out);
    const std::string csv = sweep_csv(points);
    std::fputs(csv.c_str(), stdout);
    write_text(request.out / "accuracy-time.csv", csv);
    write_text(request.out / "accuracy-time.svg", sweep_svg(points, scene->title));
    return exit_done;
}

}  // namespace hanei
