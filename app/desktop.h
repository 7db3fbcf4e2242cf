/// The window's entrance: opens a project on the desktop, or plays a script on it without one.
#pragma once

#include "ui/panels/project_door.h"

#include <filesystem>
#include <optional>

namespace hanei {

struct DesktopRequest {
    std::filesystem::path project;                    ///< empty: the start room, under no name yet
    std::optional<std::filesystem::path> script;      ///< play this without a window or display, then end
    std::optional<std::filesystem::path> state_file;  ///< keep the window's state here as JSON, for test drivers
    /// Where preferences and unsaved work are kept. None: as the system says; of scripts, nothing is kept.
    std::optional<std::filesystem::path> user_folder;
    int width = 1280;
    int height = 800;
    float scale = 0.0F;  ///< of letters and controls, 1 to 3; 0: as the screen says, in a script 1
};

/// Returns   an exit code of the command line: 0 done, 1 a script's expectation failed, 2 the project
///           or the script cannot be read, 3 no window or no OpenGL.
int run_desktop(const DesktopRequest& request);

/// The window's way to project and luminaire files.
ProjectDoor project_door();

}  // namespace hanei
