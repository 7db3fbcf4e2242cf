/// Reading and writing for the commands: findings go to stderr, results are written whole or not at all.
#pragma once

#include "engine/project/project_file.h"

#include <filesystem>
#include <optional>
#include <string_view>

namespace hanei {

/// Prints every finding, one a line.
void print_findings(const Diagnostics& findings);

/// The project, its faults printed; empty when it cannot be used.
std::optional<Project> open_project(const std::filesystem::path& file);

/// Written beside the target and renamed. Throws std::runtime_error naming the file when the disk refuses.
void write_text(const std::filesystem::path& file, std::string_view text);

/// Something of the program's own, such as "assets/reference": beside the program, in the source tree, or installed.
std::filesystem::path own_file(const std::filesystem::path& name);

/// The room the program opens with when none is named: beside the program, in the source tree, or installed.
std::filesystem::path start_room();

}  // namespace hanei
