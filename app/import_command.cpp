#include "app/exchange_commands.h"
#include "app/exit_code.h"
#include "app/files.h"
#include "engine/edit/join.h"
#include "engine/project/gltf_import.h"
#include "engine/project/gltf_units.h"
#include "engine/scene/scene_check.h"

#include <charconv>
#include <cstdio>

namespace hanei {

namespace {

/// Metres of a unit: by its name, or as a number of them.
std::optional<double> metres_of(const std::string& unit) {
    if (const auto metres = metres_of_unit(unit)) return metres;
    double metres = 0.0;
    const auto [end, fault] = std::from_chars(unit.data(), unit.data() + unit.size(), metres);
    const bool sound = fault == std::errc{} && end == unit.data() + unit.size() && metres >= 1e-6 && metres <= 1e6;
    return sound ? std::optional(metres) : std::nullopt;
}

void print_summary(const GltfImport& import) {
    std::printf("%s; furniture %zu (solids %d), free surfaces %d, luminaires %d%s\n", size_text(import.size).c_str(),
                import.scene->furniture.size(), import.solids, import.sheets, import.luminaires,
                import.scene->room ? ", a room" : "");
}

}  // namespace

int import_command(const ImportRequest& request) {
    const auto metres = metres_of(request.unit);
    if (!metres) {
        std::fprintf(stderr, "--unit: \"%s\" is no unit; write m, cm, mm, in, ft, or metres from 1e-6 to 1e6\n",
                     request.unit.c_str());
        return exit_bad_input;
    }
    std::optional<Project> project{Project{}};
    if (request.into) project = open_project(*request.into);
    if (!project) return exit_bad_input;
    GltfImportOptions wanted;
    wanted.metres_per_unit = *metres;
    wanted.up = request.up == "z" ? GltfUpAxis::z : GltfUpAxis::y;
    if (request.as == "furniture") wanted.kind = GltfKind::furniture;
    if (request.as == "room") wanted.kind = GltfKind::room;
    GltfImport import = import_gltf(request.file, wanted);
    print_findings(import.findings);
    if (!import.scene) return exit_bad_input;
    if (request.at.size() == 2) {
        const double floor = project->scene.room ? project->scene.room->floor_height : 0.0;
        import.scene = stood_at(std::move(*import.scene), {request.at[0], request.at[1]}, floor);
    }
    const bool replaces = project->scene.room && import.scene->room;
    if (replaces) std::fputs("the room of the file takes the place of the project's\n", stderr);
    if (request.into) {
        project->scene = joined(std::move(project->scene), *import.scene);
    } else {
        project->scene = *import.scene;
        project->settings = import.settings.value_or(Settings{});
        if (project->scene.title.empty()) project->scene.title = request.file.stem().string();
    }
    print_findings(check_scene(project->scene));
    if (const auto fault = write_project(*project, request.out)) {
        print_findings({*fault});
        return exit_machine;
    }
    print_summary(import);
    return exit_done;
}

}  // namespace hanei
