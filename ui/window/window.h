/// The window on the screen.
#pragma once

#include "ui/window/desk.h"

#include <filesystem>
#include <optional>

namespace hanei {

struct WindowRequest {
    ProjectContent content;
    std::filesystem::path file;
    ProjectDoor door;
    PixelSize size{1280, 800};
    std::optional<std::filesystem::path> state_file;  ///< the window's state as JSON, after every frame
    float scale = 0.0F;                               ///< of letters and controls; 0: as the screen says
};

/// Opens the window and returns when it is closed. Draws only when something happened: an idle
/// window uses no processor time. Throws std::runtime_error when there is no display or no OpenGL.
void run_window(WindowRequest request);

}  // namespace hanei
