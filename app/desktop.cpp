#include "app/desktop.h"

#include "app/built_in_cases.h"
#include "app/clipboard.h"
#include "app/exit_code.h"
#include "app/files.h"
#include "app/lit_picture.h"
#include "app/user_folders.h"
#include "engine/edit/edit.h"
#include "engine/project/gltf_import.h"
#include "engine/project/luminaires.h"
#include "engine/project/measured_file.h"
#include "engine/project/project_file.h"
#include "engine/project/text_file.h"
#include "ui/window/script.h"
#include "ui/window/window.h"

#include <algorithm>
#include <cstdio>
#include <fstream>
#include <iostream>
#include <sstream>
#include <stdexcept>

namespace hanei {
namespace {

Opened<ProjectContent> open_content(const std::filesystem::path& file) {
    ProjectRead read = read_project(file);
    Opened<ProjectContent> opened{{}, std::move(read.findings)};
    if (read.project) opened.content = ProjectContent{std::move(read.project->scene), read.project->settings};
    return opened;
}

/// A luminaire of a container goes by the name its container gives it.
Opened<std::vector<Photometry>> photometries_of(const std::filesystem::path& file) {
    LuminairesRead read = read_luminaires(file);
    Opened<std::vector<Photometry>> opened{{}, std::move(read.findings)};
    if (read.luminaires.empty()) return opened;
    std::vector<Photometry>& photometries = opened.content.emplace();
    for (NamedPhotometry& luminaire : read.luminaires) {
        luminaire.photometry.name = std::move(luminaire.name);
        photometries.push_back(std::move(luminaire.photometry));
    }
    return opened;
}

ProjectDoor door_for(const DesktopRequest& request) {
    ProjectDoor door = project_door();
    if (request.script && !request.user_folder) return door;
    if (const auto folders = user_folders(request.user_folder)) door.user = user_door(*folders);
    return door;
}

/// The project that is named; else the start room, so that there is light to look at, else an empty room.
std::optional<ProjectContent> first_content(const std::filesystem::path& named) {
    const std::filesystem::path file = named.empty() ? start_room() : named;
    if (named.empty() && !std::filesystem::exists(file)) return ProjectContent{empty_room(), {}};
    const std::optional<Project> project = open_project(file);
    if (!project) return std::nullopt;
    return ProjectContent{project->scene, project->settings};
}

int play(const std::filesystem::path& file, ProjectContent content, const DesktopRequest& request) {
    std::ifstream stream(file, std::ios::binary);
    std::stringstream text;
    text << stream.rdbuf();
    if (!stream) {
        std::cerr << file.string() << ": this script cannot be read\n";
        return exit_bad_input;
    }
    Driver driver({std::move(content),
                   request.project,
                   door_for(request),
                   {request.width, request.height},
                   request.scale > 0.0F ? request.scale : 1.0F});
    const auto fault = play_script(text.str(), file.string(), driver, std::cout);
    if (!fault) return exit_done;
    std::cerr << to_text(*fault) << '\n';
    return exit_answer_is_no;
}

Opened<ModelContent> model_of(const std::filesystem::path& file, const ModelReading& how) {
    GltfImportOptions wanted;
    wanted.metres_per_unit = how.metres_per_unit;
    wanted.up = how.z_up ? GltfUpAxis::z : GltfUpAxis::y;
    wanted.kind = how.kind == ModelReading::Kind::furniture ? GltfKind::furniture
                  : how.kind == ModelReading::Kind::room    ? GltfKind::room
                                                            : GltfKind::automatic;
    GltfImport import = import_gltf(file, wanted);
    Opened<ModelContent> opened{{}, std::move(import.findings)};
    if (import.scene)
        opened.content = ModelContent{std::move(*import.scene), import.size,    import.solids, import.sheets,
                                      import.luminaires,        import.settings};
    return opened;
}

std::optional<Diagnostic> export_model(const Solution& solution, const ViewOptions& look,
                                       const std::filesystem::path& file, const std::stop_token& stop) {
    std::optional<LitPicture> picture;
    if (solution.display) picture = lit_picture(solution, look);
    const std::string text =
        gltf_file({*solution.scene, solution.settings}, picture ? &*picture : nullptr, file.extension() != ".gltf");
    if (stop.stop_requested()) return std::nullopt;
    return write_text_file(file, text);
}

std::vector<std::filesystem::path> examples() {
    std::vector<std::filesystem::path> files;
    std::error_code none;
    for (const auto& entry : std::filesystem::directory_iterator(start_room().parent_path(), none))
        if (entry.path().extension() == ".hanei") files.push_back(entry.path());
    std::sort(files.begin(), files.end());
    return files;
}

}  // namespace

ProjectDoor project_door() {
    ProjectDoor door;
    door.open = open_content;
    door.save = [](const ProjectContent& content, const std::filesystem::path& file) {
        return write_project({content.scene, content.settings}, file);
    };
    door.read_text = [](std::string_view text) {
        ProjectRead read = read_project_text(text, {});
        Opened<ProjectContent> opened{std::nullopt, std::move(read.findings)};
        if (read.project) opened.content = ProjectContent{std::move(read.project->scene), read.project->settings};
        return opened;
    };
    door.read_luminaires = photometries_of;
    door.text = [](const ProjectContent& content) { return project_text({content.scene, content.settings}); };
    door.copy_picture = copy_png;
    door.read_model = model_of;
    door.export_model = export_model;
    door.examples = examples;
    door.validate = [](const Work& work, const std::function<void(const ValidationRow&)>& told) {
        const BuiltInCases cases = built_in_cases();
        if (has_errors(cases.findings)) throw std::runtime_error(to_text(cases.findings.front()));
        return validate(
            cases, [](Settings&) {}, work, [&](const CaseVerdict&, const ValidationRow& row) { told(row); });
    };
    door.read_measured = [](const std::filesystem::path& file) {
        MeasuredRead read = read_measured(file);
        return Opened<MeasuredValues>{std::move(read.values), std::move(read.findings)};
    };
    return door;
}

int run_desktop(const DesktopRequest& request) {
    std::optional<ProjectContent> content = first_content(request.project);
    if (!content) return exit_bad_input;
    try {
        if (request.script) return play(*request.script, std::move(*content), request);
        run_window({std::move(*content),
                    request.project,
                    door_for(request),
                    {request.width, request.height},
                    request.state_file,
                    request.scale});
        return exit_done;
    } catch (const std::runtime_error& fault) {
        std::cerr << fault.what() << '\n';
        return exit_machine;
    }
}

}  // namespace hanei
