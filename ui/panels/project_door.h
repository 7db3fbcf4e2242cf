/// The window's way to the disk. Panels know no file formats: the program hands them these.
#pragma once

#include "ui/panels/project_content.h"
#include "ui/panels/user_door.h"

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace hanei {

struct ProjectDoor {
    std::function<Opened<ProjectContent>(const std::filesystem::path&)> open;
    std::function<std::optional<Diagnostic>(const ProjectContent&, const std::filesystem::path&)> save;
    /// Every luminaire of a file, each under the name a list of them shows; empty content when there is none.
    std::function<Opened<std::vector<Photometry>>(const std::filesystem::path&)> read_luminaires;
    UserDoor user = {};
    std::function<std::string(const ProjectContent&)> text = {};  ///< as it would be saved
    /// A PNG to the system's clipboard. Returns why not, or nothing.
    std::function<std::optional<std::string>(std::string_view)> copy_picture = {};
};

}  // namespace hanei
