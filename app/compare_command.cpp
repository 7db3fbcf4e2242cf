#include "app/exit_code.h"
#include "app/files.h"
#include "app/profile_command.h"
#include "engine/study/study.h"
#include "ui/view/difference.h"
#include "ui/view/offscreen.h"

#include <cstdio>
#include <fmt/format.h>

namespace hanei {
namespace {

SolutionSnapshot solved(const std::filesystem::path& file, const CompareRequest& request) {
    auto project = open_project(file);
    if (!project) return nullptr;
    request.change(project->settings);
    const auto scene = std::make_shared<const Scene>(std::move(project->scene));
    return Study().run(scene, project->settings, StudyRequest{.display = true}, Work{});
}

std::string figure(const std::optional<GridFigures>& figures) {
    return figures ? fmt::format("{:.1f}", figures->mean) : "-";
}

void print_grids(const Solution& first, const Solution& second) {
    std::printf("%-28s %10s %10s %10s %8s\n", "grid, mean lx", "A", "B", "B - A", "%");
    for (const GridDifference& row : compared_grids(first, second)) {
        const bool both = row.first && row.second;
        const double by = both ? row.second->mean - row.first->mean : 0.0;
        const std::string share =
            both && row.first->mean > 0.0 ? fmt::format("{:+.1f}", 100.0 * by / row.first->mean) : "-";
        std::printf("%-28s %10s %10s %10s %8s\n", row.name.c_str(), figure(row.first).c_str(),
                    figure(row.second).c_str(), both ? fmt::format("{:+.1f}", by).c_str() : "-", share.c_str());
    }
}

std::optional<Camera> camera_for(const std::string& view, const Scene& scene, double aspect) {
    if (view == "plan") return plan_view(bounds_of(scene), aspect);
    if (view == "overview" || (view.empty() && scene.views.empty())) return overview(bounds_of(scene), aspect);
    if (view.empty()) return camera_of(scene.views.front());
    for (std::size_t k = 0; k < scene.views.size(); ++k)
        if (scene.views[k].name == view || std::to_string(k + 1) == view) return camera_of(scene.views[k]);
    std::fprintf(stderr, "--view: no view \"%s\"; there are overview, plan and those of B\n", view.c_str());
    return std::nullopt;
}

}  // namespace

int compare_command(const CompareRequest& request) {
    const SolutionSnapshot first = solved(request.first, request), second = solved(request.second, request);
    if (!first || !second) return exit_bad_input;
    print_grids(*first, *second);
    if (!request.out) return exit_done;
    const SolutionSnapshot difference = difference_of(*first, *second);
    PictureRequest picture;
    picture.size = {request.width, request.height};
    const LightPart part = picture.options.part;
    picture.options = as_difference(picture.options, request.range.value_or(suggested_difference(*difference, part)));
    const auto camera = camera_for(request.view, *second->scene, view_size(picture).aspect());
    if (!camera) return exit_bad_input;
    picture.camera = *camera;
    picture.caption =
        fmt::format("{} minus {}\nTotal illuminance; blue and striped: less, orange: more, grey: nothing to compare",
                    request.second.filename().string(), request.first.filename().string());
    const OffscreenContext context;
    write_png(render_picture(difference, picture), *request.out, {{"Software", "Hanei " HANEI_VERSION}});
    return exit_done;
}

}  // namespace hanei
