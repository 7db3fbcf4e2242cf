/// The window's way to the disk. Panels know no file formats: the program hands them these.
#pragma once

#include "ui/panels/project_content.h"
#include "ui/panels/user_door.h"

#include <filesystem>
#include <functional>
#include <optional>
#include <vector>

namespace hanei {

struct ProjectDoor {
    std::function<Opened<ProjectContent>(const std::filesystem::path&)> open;
    std::function<std::optional<Diagnostic>(const ProjectContent&, const std::filesystem::path&)> save;
    /// Every luminaire of a file, each under the name a list of them shows; empty content when there is none.
    std::function<Opened<std::vector<Photometry>>(const std::filesystem::path&)> read_luminaires;
    UserDoor user = {};
};

}  // namespace hanei
