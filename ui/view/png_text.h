/// The words that travel with a PNG.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace hanei {

using PngText = std::vector<std::pair<std::string, std::string>>;

/// Keys and texts of a PNG file's tEXt and plain iTXt chunks, in file order; Latin-1 becomes UTF-8.
/// What is packed is left out. Empty when the file is no PNG or breaks off.
std::optional<PngText> read_png_text(const std::filesystem::path& file);

}  // namespace hanei
