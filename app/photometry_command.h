#pragma once

#include <filesystem>
#include <iosfwd>
#include <optional>

namespace hanei {

/// Prints what a luminaire file says and what follows from it, one section a luminaire, and writes the
/// same as JSON.
/// Returns   an ExitCode: bad input, with its faults on `err`, when the file holds no photometry.
int photometry_command(const std::filesystem::path& file, const std::optional<std::filesystem::path>& json,
                       std::ostream& out, std::ostream& err);

}  // namespace hanei
