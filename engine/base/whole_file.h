#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

namespace hanei {

/// Writes beside the target, waits until the disk holds it, and renames: the target is whole at every
/// moment, after a power cut too, and untouched when the disk refuses. It keeps its permissions; a
/// symbolic link is followed. A target that is no plain file (a device, a folder) is refused.
///
/// Returns   nothing, or the reason as a sentence without the file's name: what refused and what to do.
/// Cost      two waits for the disk: milliseconds on flash, more on a busy or turning disk.
std::optional<std::string> write_whole_file(const std::filesystem::path& file, std::string_view bytes);

/// The same for what only tells others of the present moment: it does not wait for the disk.
std::optional<std::string> write_passing_file(const std::filesystem::path& file, std::string_view bytes);

/// The folder with all above it, where it is not there yet. Returns as write_whole_file().
std::optional<std::string> make_folder(const std::filesystem::path& folder);

}  // namespace hanei
