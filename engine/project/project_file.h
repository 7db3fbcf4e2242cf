/// The project file NAME.hanei: UTF-8 JSON with a schema (assets/hanei-project.schema.json).
#pragma once

#include "engine/base/diagnostic.h"
#include "engine/plan/settings.h"
#include "engine/scene/scene.h"

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

namespace hanei {

/// What a project file holds.
struct Project {
    Scene scene;
    Settings settings;
    bool operator==(const Project&) const = default;
};

/// A project, or why there is none. With errors `project` is empty: nothing is half loaded.
struct ProjectRead {
    std::optional<Project> project;
    Diagnostics findings;  ///< warnings too: unknown fields, repaired windings
};

/// Checks the form of the file (types, ranges, references, photometric files it names) and then the
/// scene (check_scene). Every fault is reported with file, line and field.
/// Unknown fields are kept (and warned about); a newer version is refused with a sentence.
ProjectRead read_project(const std::filesystem::path& file);
ProjectRead read_project_text(std::string_view json, const std::filesystem::path& file);

/// The file's text; read_project_text gives back an equal project.
std::string project_text(const Project& project);

/// Written beside its target and renamed. Returns what went wrong, or nothing.
std::optional<Diagnostic> write_project(const Project& project, const std::filesystem::path& file);

}  // namespace hanei
