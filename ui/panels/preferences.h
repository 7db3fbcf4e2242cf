/// What the user likes, kept for all projects: not part of any scene and not of undo.
#pragma once

#include "ui/panels/language.h"
#include "ui/view/illuminance_unit.h"
#include "ui/view/length_unit.h"

#include <filesystem>
#include <string>
#include <vector>

namespace hanei {

enum class Theme { dark, light };

struct Preferences {
    Language language = Language::english;
    Theme theme = Theme::dark;
    double scale = 0.0;  ///< of letters and distances, 1 to 3; 0: as the screen says
    LengthUnit length = LengthUnit::metre;
    IlluminanceUnit illuminance = IlluminanceUnit::lux;
    float left_width = 224.0F, right_width = 308.0F, bottom_height = 196.0F;  ///< of the panels, at scale 1
    std::vector<std::filesystem::path> recent;                                ///< projects, the newest first
    double autosave = 60.0;       ///< s, 5 to 600: unsaved work is kept at least as often
    bool restores_layout = true;  ///< the panels' sizes are those of the last time
    std::string picture_name = "{project} {view} {part} {date}.png";  ///< template of exported files' names
    bool glides = true;                                               ///< from one view to another, not at once
    std::string unknown = {};      ///< fields of a newer program, as the text of a JSON object
    bool shows_start_page = true;  ///< at a start without a project
    bool operator==(const Preferences&) const = default;
};

}  // namespace hanei
