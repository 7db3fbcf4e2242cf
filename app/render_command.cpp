#include "app/commands.h"
#include "app/exit_code.h"
#include "app/files.h"
#include "engine/study/study.h"
#include "ui/view/offscreen.h"

#include <algorithm>
#include <cstdio>
#include <optional>

namespace hanei {

namespace {

std::optional<Camera> camera_for(const RenderRequest& request, const Scene& scene, double aspect) {
    const Bounds bounds = bounds_of(scene);
    if (request.view == "overview" || (request.view.empty() && scene.views.empty())) return overview(bounds, aspect);
    if (request.view == "plan") return plan_view(bounds, aspect);
    if (request.view.empty()) return camera_of(scene.views.front());
    for (std::size_t k = 0; k < scene.views.size(); ++k) {
        if (scene.views[k].name == request.view || std::to_string(k + 1) == request.view)
            return camera_of(scene.views[k]);
    }
    return std::nullopt;
}

/// Part, scale and steps by their names, as the options' own check allows them.
ViewOptions options_for(const RenderRequest& request) {
    ViewOptions options;
    for (const LightPart part : {LightPart::total, LightPart::direct, LightPart::interreflected, LightPart::unshadowed})
        if (name_of(part) == request.part) options.part = part;
    for (const Scale scale : {Scale::false_colour, Scale::photo})
        if (name_of(scale) == request.scale) options.scale = scale;
    if (request.steps == "linear") options.steps = ColourSteps::linear;
    if (request.steps == "en") options.steps = ColourSteps::standard_steps;
    return options;
}

void print_unknown_view(const RenderRequest& request, const Scene& scene) {
    std::fprintf(stderr, "--view: no view \"%s\"; there are overview, plan", request.view.c_str());
    for (const View& view : scene.views) std::fprintf(stderr, ", \"%s\"", view.name.c_str());
    std::fputs("\n", stderr);
}

}  // namespace

int render_command(const RenderRequest& request) {
    auto project = open_project(request.project);
    if (!project) return exit_bad_input;
    request.change(project->settings);
    const auto scene = std::make_shared<const Scene>(std::move(project->scene));
    const bool four_up = request.part == "four-up";
    PictureRequest picture;
    picture.options = options_for(request);
    picture.size = {request.width, request.height};
    picture.annotated = !request.plain;
    const auto camera = camera_for(request, *scene, view_size(picture).aspect());
    if (!camera) {
        print_unknown_view(request, *scene);
        return exit_bad_input;
    }
    picture.camera = *camera;

    Study study;
    StudyRequest wanted{.display = true};
    wanted.unshadowed = four_up || picture.options.part == LightPart::unshadowed;
    const SolutionSnapshot solution = study.run(scene, project->settings, wanted, Work{});
    picture.options.range = suggested_range(*solution);
    if (request.low) picture.options.range.low = *request.low;
    if (request.high) picture.options.range.high = *request.high;
    if (!(picture.options.range.low < picture.options.range.high)) {
        std::fprintf(stderr, "--low, --high: %g to %g lx is no range; low must be less than high\n",
                     picture.options.range.low, picture.options.range.high);
        return exit_bad_input;
    }

    const OffscreenContext context;
    const Image image = four_up ? render_four_up(solution, picture) : render_picture(solution, picture);
    write_png(image, request.out, {{"Title", scene->title}, {"Software", "Hanei " HANEI_VERSION}});
    return exit_done;
}

}  // namespace hanei
