/// What a picture says of itself to whoever finds it later.
#pragma once

#include "ui/view/png_text.h"
#include "ui/view/view_options.h"

#include <chrono>

namespace hanei {

/// Title, Software, Description (quantity, unit, range, method, error), Creation Time and the project's hash,
/// for write_png().
PngText picture_text(const Solution& solution, const ViewOptions& look, const std::string& project_hash,
                     std::chrono::system_clock::time_point when);

/// Sixteen hexadecimal digits of a text, the same on every machine (FNV-1a): tells projects apart, proves nothing.
std::string short_hash(std::string_view text);

}  // namespace hanei
