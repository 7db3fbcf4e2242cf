#include "app/why_command.h"

#include "app/exit_code.h"
#include "app/files.h"
#include "engine/report/contributions_report.h"
#include "engine/study/study.h"

#include <cstdio>

namespace hanei {
namespace {

struct Place {
    Vec3 position{0.0};
    Vec3 normal{0.0, 0.0, 1.0};
};

std::optional<Place> named_place(const std::string& wanted, const Scene& scene) {
    for (std::size_t k = 0; k < scene.points.size(); ++k)
        if (scene.points[k].name == wanted || std::to_string(k + 1) == wanted)
            return Place{scene.points[k].position, scene.points[k].normal};
    std::fprintf(stderr, "--point: no calculation point \"%s\"; there are %zu", wanted.c_str(), scene.points.size());
    for (const CalculationPoint& point : scene.points) std::fprintf(stderr, ", \"%s\"", point.name.c_str());
    std::fputs("\n", stderr);
    return std::nullopt;
}

std::optional<Place> place_of(const WhyRequest& request, const Scene& scene) {
    if (!request.point.empty()) return named_place(request.point, scene);
    if (request.at.size() != 3) {
        std::fputs("--at or --point: say where, as --at X,Y,Z in metres or --point NAME\n", stderr);
        return std::nullopt;
    }
    const Place place{{request.at[0], request.at[1], request.at[2]},
                      {request.normal[0], request.normal[1], request.normal[2]}};
    if (glm::length(place.normal) > 0.0) return place;
    std::fputs("--normal: 0,0,0 has no direction; write the direction that the place faces, such as 0,0,1\n", stderr);
    return std::nullopt;
}

}  // namespace

int why_command(const WhyRequest& request) {
    auto project = open_project(request.project);
    if (!project) return exit_bad_input;
    request.change(project->settings);
    const auto scene = std::make_shared<const Scene>(std::move(project->scene));
    const auto place = place_of(request, *scene);
    if (!place) return exit_bad_input;
    Study study;
    const SolutionSnapshot solution = study.run(scene, project->settings, {}, Work{});
    const auto made = study.contributions(solution, place->position, glm::normalize(place->normal), Work{});
    std::fputs(contributions_text(*made).c_str(), stdout);
    if (request.json) write_text(*request.json, contributions_json(*made));
    return exit_done;
}

}  // namespace hanei
