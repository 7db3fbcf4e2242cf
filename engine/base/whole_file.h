#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

namespace hanei {

/// Writes beside the target and renames, so that the target is whole at every moment and untouched
/// when the disk refuses. A target that is no plain file (a device, a folder) is refused.
/// Returns   nothing, or the reason as a sentence without the file's name.
std::optional<std::string> write_whole_file(const std::filesystem::path& file, std::string_view bytes);

}  // namespace hanei
