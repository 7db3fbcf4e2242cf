#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace hanei {

/// Hands a PNG to the clipboard by the system's own tool: wl-copy under Wayland, xclip under X11.
/// Returns   nothing, or a sentence that says what is missing.
/// Cost      a file in the temporary folder and the tool's start; it keeps the picture until another is copied.
std::optional<std::string> copy_png(std::string_view png);

}  // namespace hanei
