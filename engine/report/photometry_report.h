/// What a luminaire file says and what follows from it, as text and JSON.
#pragma once

#include "engine/scene/photometry.h"

#include <string>
#include <string_view>
#include <vector>

namespace hanei {

/// A table for a terminal: declared and computed figures, planes 0 and 90, warnings.
std::string photometry_text(const Photometry& photometry);

/// The same figures for programs. `file` is the name they are reported under.
std::string photometry_json(const Photometry& photometry, std::string_view file);

/// The luminaires of one file: one as photometry_json has it, several in a list "luminaires".
///
/// Needs     one or more.
std::string photometries_json(const std::vector<Photometry>& photometries, std::string_view file);

std::string_view name_of(PhotometricType type);
std::string_view name_of(PhotometricSymmetry symmetry);  ///< "about the plane 0-180"
std::string_view name_of(OpeningShape shape);            ///< "vertical cylinder"

}  // namespace hanei
