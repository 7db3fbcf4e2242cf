#include "app/exchange_commands.h"
#include "app/exit_code.h"
#include "app/files.h"
#include "app/interrupt.h"
#include "app/lit_picture.h"
#include "app/progress_line.h"
#include "engine/study/study.h"

#include <cstdio>

namespace hanei {

namespace {

/// Null when stopped.
SolutionSnapshot solved(const SceneSnapshot& scene, const Settings& settings, const std::stop_token& stop) {
    Progress progress;
    const ProgressLine line(progress);
    Study study;
    return study.run(scene, settings, StudyRequest{.display = true}, Work{1, stop, &progress});
}

}  // namespace

int export_command(const ExportRequest& request) {
    const std::string ending = request.out.extension().string();
    if (ending != ".glb" && ending != ".gltf") {
        std::fprintf(stderr, "--out: \"%s\" ends in neither .glb nor .gltf\n", request.out.c_str());
        return exit_bad_input;
    }
    auto project = open_project(request.project);
    if (!project) return exit_bad_input;
    const auto scene = std::make_shared<const Scene>(project->scene);
    Settings settings = project->settings;
    request.change(settings);
    std::optional<LitPicture> picture;
    if (request.colours != "none") {
        Interrupt interrupt;
        const SolutionSnapshot solution = solved(scene, settings, interrupt.token());
        if (!solution) {
            interrupt.pass_on();
            return exit_machine;
        }
        ViewOptions look;
        look.scale = request.colours == "photo" ? Scale::photo : Scale::false_colour;
        look.range = suggested_range(*solution);
        if (request.low) look.range.low = *request.low;
        if (request.high) look.range.high = *request.high;
        if (!(look.range.low < look.range.high)) {
            std::fprintf(stderr, "--low, --high: %g to %g lx is no range; low must be less than high\n", look.range.low,
                         look.range.high);
            return exit_bad_input;
        }
        picture = lit_picture(*solution, look);
    }
    if (const auto fault = write_gltf(*project, picture ? &*picture : nullptr, request.out)) {
        print_findings({*fault});
        return exit_machine;
    }
    return exit_done;
}

}  // namespace hanei
