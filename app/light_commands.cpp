#include "app/light_commands.h"

#include "app/exit_code.h"
#include "app/files.h"
#include "engine/edit/control_groups.h"
#include "engine/edit/hanging.h"
#include "engine/edit/start_layout.h"
#include "engine/project/luminaires.h"
#include "engine/scene/scene_check.h"
#include "engine/study/study.h"

#include <algorithm>
#include <cstdio>

namespace hanei {

namespace {

std::optional<Photometry> first_luminaire(const std::filesystem::path& file) {
    LuminairesRead read = read_luminaires(file);
    print_findings(read.findings);
    if (read.luminaires.empty()) return std::nullopt;
    if (read.luminaires.size() > 1)
        std::fprintf(stderr, "%s: holds %zu luminaires; the first is used\n", file.c_str(), read.luminaires.size());
    return std::move(read.luminaires.front().photometry);
}

MountingWish mounting_from(const LayoutRequest& request) {
    MountingWish wish;
    wish.suspension = request.suspension;
    if (request.mounting == "surface") wish.mounting = Mounting::surface;
    if (request.mounting == "pendant") wish.mounting = Mounting::pendant;
    return wish;
}

void print_answer(const LumenAnswer& answer, const LayoutRequest& request) {
    std::printf("%d luminaires in %d x %d; predicted mean %.0f lx for %.0f lx (direct %.0f lx)\n", answer.count(),
                answer.columns, answer.rows, answer.mean, request.target, answer.direct);
    std::printf("utilization %.2f, room index %.2f, %.2f m above the working plane, spacing to height %.2f of %.2f\n",
                answer.utilization, answer.room_index, answer.height, answer.spacing_to_height, answer.spacing_limit);
    if (answer.watts > 0.0) std::printf("%.0f W, %.1f W/m2\n", answer.watts, answer.watts_per_m2);
    if (answer.spacing_to_height > answer.spacing_limit)
        std::printf("the spacing is wide for this luminaire: it will be darker between luminaires\n");
}

/// Mean of the working plane by the solution.
std::optional<double> computed_mean(const Scene& scene, const Settings& settings) {
    const ObjectId plane = working_plane_of(scene);
    const SolutionSnapshot solution =
        Study().run(std::make_shared<const Scene>(scene), settings, StudyRequest{}, Work{});
    for (const GridResult& grid : solution->grids)
        if (grid.grid == plane) return figures_of(grid).mean;
    return std::nullopt;
}

}  // namespace

int layout_command(const LayoutRequest& request) {
    auto project = open_project(request.project);
    if (!project) return exit_bad_input;
    if (request.change) request.change(project->settings);
    auto photometry = first_luminaire(request.luminaire);
    if (!photometry) return exit_bad_input;
    LumenWish wish{request.target, request.working_plane, request.border, mounting_from(request)};
    int columns = 0, rows = 0;
    if (std::sscanf(request.grid.c_str(), "%dx%d", &columns, &rows) == 2) {
        wish.columns = columns;
        wish.rows = rows;
    }
    Added hung = with_measured_luminaire(std::move(project->scene), std::move(*photometry));
    const auto luminaire = std::find_if(hung.scene.luminaires.begin(), hung.scene.luminaires.end(),
                                        [&](const Luminaire& each) { return each.id == hung.object; });
    const LumenAnswer answer = lumen_method(hung.scene, *luminaire, wish);
    if (!answer.refusal.empty()) {
        std::fprintf(stderr, "%s: %s\n", request.project.c_str(), answer.refusal.c_str());
        return exit_answer_is_no;
    }
    project->scene = with_start_layout(std::move(hung.scene), hung.object, wish, answer).scene;
    print_answer(answer, request);
    print_findings(check_scene(project->scene));
    if (request.solve)
        if (const auto mean = computed_mean(project->scene, project->settings))
            std::printf("computed mean %.0f lx: predicted %+.1f %%\n", *mean, 100.0 * (answer.mean / *mean - 1.0));
    if (const auto fault = write_project(*project, request.out)) {
        print_findings({*fault});
        return exit_machine;
    }
    return exit_done;
}

bool recall_light_scene(Scene& scene, const std::string& name, const std::filesystem::path& project) {
    if (name.empty()) return true;
    std::string there;
    for (const LightScene& each : scene.light_scenes) {
        if (each.name == name) {
            scene = recalled(std::move(scene), each.id);
            return true;
        }
        there += (there.empty() ? "there are \"" : ", \"") + each.name + "\"";
    }
    std::fprintf(stderr, "%s: there is no light scene \"%s\"; %s\n", project.c_str(), name.c_str(),
                 there.empty() ? "there are none" : there.c_str());
    return false;
}

}  // namespace hanei
