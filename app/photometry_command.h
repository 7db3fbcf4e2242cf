#pragma once

#include "engine/base/diagnostic.h"
#include "engine/scene/scene.h"

#include <filesystem>
#include <iosfwd>
#include <optional>
#include <string>

namespace hanei {

/// Prints what a luminaire file says and what follows from it, one section a luminaire, and writes the
/// same as JSON. Figures are for the lamp set that is asked for, counted from 1; else for the first.
/// Returns   an ExitCode: bad input, with its faults on `err`, when the file holds no photometry or a
///           luminaire no such lamp set.
int photometry_command(const std::filesystem::path& file, std::optional<int> lamp_set,
                       const std::optional<std::filesystem::path>& json, std::ostream& out, std::ostream& err);

/// What is to be said of the photometries of a project: warnings of their files, and differences between
/// what they declare and what their intensities give. What `known` says already is left out.
Diagnostics photometry_findings(const Scene& scene, const std::string& file, const Diagnostics& known);

}  // namespace hanei
