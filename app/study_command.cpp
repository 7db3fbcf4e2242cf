#include "app/calibration_file.h"
#include "app/commands.h"
#include "app/exit_code.h"
#include "app/files.h"
#include "app/interrupt.h"
#include "app/progress_line.h"
#include "app/reference_scene.h"
#include "engine/base/tiles.h"
#include "engine/base/whole_file.h"
#include "engine/report/sweep_report.h"

#include <cstdio>
#include <filesystem>

namespace hanei {

namespace {

/// What is swept, from a project or from a reference case.
struct Swept {
    SceneSnapshot scene;
    Settings settings;
    std::optional<SweepExpected> expected;
    std::string title;
};

std::optional<Swept> from_project(const std::filesystem::path& file) {
    auto project = open_project(file);
    if (!project) return std::nullopt;
    if (project->scene.points.empty() && project->scene.grids.empty()) {
        std::fprintf(stderr, "%s: there are no calculation grids or points to compare at\n", file.c_str());
        return std::nullopt;
    }
    const auto scene = std::make_shared<const Scene>(std::move(project->scene));
    return Swept{scene, project->settings, std::nullopt, scene->title};
}

/// The first case of the file that can be computed and has points.
std::optional<Swept> from_reference(const std::filesystem::path& file) {
    const ReferenceRead read = read_reference(file);
    print_findings(read.findings);
    if (has_errors(read.findings)) return std::nullopt;
    for (const ReferenceCase& reference : read.cases) {
        if (!reference.unsupported.empty() || reference.points.empty()) continue;
        constexpr double unknowns = 1000.0;  // at the middle width
        Swept swept{scene_with_points(reference), {}, SweepExpected{}, reference.id};
        swept.settings.max_patch = suitable_patch(reference.scene, unknowns);
        swept.expected->source = "the expected values of " + reference.id;
        for (const ReferencePoint& point : reference.points) {
            swept.expected->lux.push_back(point.expected);
            swept.expected->uncertainty.push_back(point.uncertainty);
            swept.expected->sets.push_back(point.set.empty() ? "points" : point.set);
        }
        return swept;
    }
    std::fprintf(stderr, "%s: no case here has points that can be computed\n", file.c_str());
    return std::nullopt;
}

}  // namespace

int study_command(const SweepRequest& request) {
    auto swept =
        request.project.extension() == ".json" ? from_reference(request.project) : from_project(request.project);
    if (!swept) return exit_bad_input;
    request.change(swept->settings);
    SweepWish wish;
    if (swept->expected) wish.expected = &*swept->expected;
    wish.budget = request.budget;
    wish.calibration = known_calibration();
    Progress progress;
    Interrupt interrupt;
    std::optional<ProgressLine> line(std::in_place, progress);
    const Sweep sweep =
        accuracy_sweep(swept->scene, swept->settings, wish, Work{hardware_threads(), interrupt.token(), &progress});
    line.reset();
    keep_learned(sweep.learned);
    std::fputs(sweep_text(sweep).c_str(), sweep.points.empty() ? stderr : stdout);
    if (!sweep.points.empty()) {
        if (const auto reason = make_folder(request.out))
            throw std::runtime_error(request.out.string() + ": " + *reason);
        write_text(request.out / "accuracy-time.csv", sweep_csv(sweep));
        write_text(request.out / "accuracy-time.svg", sweep_svg(sweep, swept->title));
    }
    if (interrupt.came()) interrupt.pass_on();
    return sweep.points.empty() ? exit_answer_is_no : exit_done;
}

}  // namespace hanei
