/// The window's way to the disk. Panels know no file formats: the program hands them these.
#pragma once

#include "engine/scene/measured_values.h"
#include "ui/panels/model_content.h"
#include "ui/panels/project_content.h"
#include "ui/panels/user_door.h"
#include "ui/panels/validation_dialog.h"
#include "ui/view/view_options.h"

#include <filesystem>
#include <functional>
#include <optional>
#include <stop_token>
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
    std::function<std::string(const ProjectContent&)> text = {};             ///< as it would be saved
    std::function<Opened<ProjectContent>(std::string_view)> read_text = {};  ///< of such a text, from the clipboard
    /// A PNG to the system's clipboard. Returns why not, or nothing.
    std::function<std::optional<std::string>(std::string_view)> copy_picture = {};
    /// Furniture, rooms and lamps of a model (glTF).
    std::function<Opened<ModelContent>(const std::filesystem::path&, const ModelReading&)> read_model = {};
    /// The solution's scene for other programs, its light coloured as a picture of these options.
    /// Nothing is written once the work shall stop.
    std::function<std::optional<Diagnostic>(const Solution&, const ViewOptions&, const std::filesystem::path&,
                                            const std::stop_token&)>
        export_model = {};
    std::function<std::vector<std::filesystem::path>()> examples = {};  ///< projects to begin with
    RunValidation validate = {};                                        ///< by the cases that come with the program
    std::function<Opened<MeasuredValues>(const std::filesystem::path&)> read_measured = {};  ///< of others (CSV)
};

}  // namespace hanei
