/// Whole files in and out.
#pragma once

#include "engine/base/diagnostic.h"

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

namespace hanei {

/// A finding about a file; line 0 and an empty field are unknown.
Diagnostic about_file(Severity severity, const std::string& file, int line, const std::string& field,
                      const std::string& message);

/// Returns   nothing, with a finding that says why, for anything but a readable file of at most 64 MB.
std::optional<std::string> read_text_file(const std::filesystem::path& file, Diagnostics& findings);

/// Writes beside the target and renames, so that the target is whole at every moment.
std::optional<Diagnostic> write_text_file(const std::filesystem::path& file, std::string_view text);

}  // namespace hanei
