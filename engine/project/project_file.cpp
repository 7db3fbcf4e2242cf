#include "engine/project/project_file.h"

#include "engine/edit/furniture_edits.h"
#include "engine/project/json_text.h"
#include "engine/project/project_reader.h"
#include "engine/project/project_writer.h"
#include "engine/project/text_file.h"
#include "engine/project/windings.h"
#include "engine/scene/scene_check.h"

#include <algorithm>

namespace hanei {

/// Anything else said about a file of another version would mislead.
bool is_readable_version(JsonReading& reading, const JsonValue& root) {
    const JsonValue* const format = root.find("format");
    if (format == nullptr || format->text != "hanei-project") {
        reading.error(format == nullptr ? root : *format, "format",
                      "this is no hanei project: the field must be \"hanei-project\"");
        return false;
    }
    const JsonValue* const version = root.find("version");
    int number = 0;
    if (version == nullptr || !take_value(reading, *version, "version", number)) {
        if (version == nullptr) reading.error(root, "version", "the field is missing; expected 1");
        return false;
    }
    if (number > project_version) {
        reading.error(*version, "version",
                      "the file is of version " + std::to_string(number) + ", this program reads up to version " +
                          std::to_string(project_version) + "; open it with a newer hanei");
    } else if (number < 1) {
        reading.error(*version, "version", "found " + version->text + ", expected 1");
    }
    return number >= 1 && number <= project_version;
}

namespace {

Project read_fields(JsonReading& reading, const JsonValue& root, const std::filesystem::path& folder) {
    Fields fields(reading, root, "");
    for (const char* const known : {"format", "version", "last_id"}) fields.take(known);
    Project project;
    JsonValue kept = json_object();
    SceneReader reader{reading, folder, {}, {}};
    reader.scene.last_id = greatest_id(root);
    fields.optional("title", reader.scene.title);
    fields.optional("maintenance_factor", reader.scene.maintenance_factor);
    read_settings(project.settings, fields, kept);
    read_materials(reader, fields);
    read_room(reader, fields);
    read_furniture(reader, fields);
    read_surfaces(reader, fields);
    read_photometries(reader, fields);
    read_control_groups(reader, fields);
    read_luminaires(reader, fields);
    read_light_scenes(reader, fields);
    read_arrangements(reader, fields);
    read_calculation(reader, fields);
    read_object_groups(reader, fields);
    read_views(reader, fields);
    read_colour_scale(reader, fields);
    reader.scene.unknown = unknown_of(fields, std::move(kept));
    project.scene = std::move(reader.scene);
    return project;
}

}  // namespace

Project read_project_fields(JsonReading& reading, const JsonValue& root, const std::filesystem::path& folder) {
    Project project = read_fields(reading, root, folder);
    for (const RepairedWinding& repair : repair_windings(project.scene)) {
        reading.findings.push_back(
            about_file(Severity::warning, reading.file, line_of(root, repair.field), repair.field, repair.message));
        reading.findings.back().place.object = repair.object.value;
    }
    for (Diagnostic& finding : settle_models(project.scene)) {
        finding.place.file = reading.file;
        finding.place.line = line_of(root, finding.place.field);
        reading.findings.push_back(std::move(finding));
    }
    return project;
}

namespace {

/// "luminaires[2]" of "luminaires[2].opening.outline", "room" of "room.plan"; sub-areas are objects
/// of their own.
std::string_view object_path(std::string_view field) {
    constexpr std::string_view sub_areas = "room.sub_areas[";
    return field.substr(0, field.find('.', field.starts_with(sub_areas) ? sub_areas.size() : 0));
}

/// Findings about the scene, each with its line. Objects whose fields could not all be read are
/// left out: what is said of them would only follow from that.
void check_read_scene(JsonReading& reading, const JsonValue& root, const Scene& scene) {
    std::vector<std::string> broken;
    for (const Diagnostic& finding : reading.findings)
        if (finding.severity == Severity::error) broken.emplace_back(object_path(finding.place.field));
    for (Diagnostic& finding : check_scene(scene)) {
        if (std::find(broken.begin(), broken.end(), object_path(finding.place.field)) != broken.end()) continue;
        finding.place.file = reading.file;
        finding.place.line = line_of(root, finding.place.field);
        reading.findings.push_back(std::move(finding));
    }
}

}  // namespace

ProjectRead read_project_text(std::string_view json, const std::filesystem::path& file) {
    JsonReading reading{file.string(), {}};
    ProjectRead read;
    const std::optional<JsonValue> root = parse_json(json, reading.file, reading.findings);
    if (root.has_value() && is_readable_version(reading, *root)) {
        Project project = read_project_fields(reading, *root, file.parent_path());
        check_read_scene(reading, *root, project.scene);
        read.project = std::move(project);
    }
    if (has_errors(reading.findings)) read.project.reset();
    read.findings = std::move(reading.findings);
    return read;
}

ProjectRead read_project(const std::filesystem::path& file) {
    Diagnostics findings;
    const std::optional<std::string> text = read_text_file(file, findings);
    if (!text.has_value()) return {std::nullopt, std::move(findings)};
    return read_project_text(*text, file);
}

std::string project_text(const Project& project) { return json_document(json_of(project)); }

std::optional<Diagnostic> write_project(const Project& project, const std::filesystem::path& file) {
    const JsonValue root = json_of(project);
    if (auto fault = unwritable(root, file)) return fault;
    return write_text_file(file, json_document(root));
}

}  // namespace hanei
