/// From what a GLDF container lists to luminaires that can be placed.
#pragma once

#include "engine/project/gldf_file.h"

#include <string>
#include <vector>

namespace hanei {

/// A luminaire for each emitter of each variant whose photometry was read (read_gldf). An emitter that is
/// not defined, or asks for a photometry that is not, is an error; so is a container without luminaires.
void name_luminaires(const GldfListing& listing, const std::string& file, std::vector<NamedPhotometry>& luminaires,
                     Diagnostics& findings);

}  // namespace hanei
