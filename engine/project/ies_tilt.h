/// How the flux of an LM-63 file's lamps depends on their tilt: the factors of TILT=INCLUDE, or of a file.
#pragma once

#include "engine/project/luminaire_findings.h"
#include "engine/scene/photometry.h"

#include <functional>
#include <optional>
#include <string>

namespace hanei {

class IesWords;

/// The text of a file beside a luminaire file, by its name; empty when it is not to be had.
using FileBeside = std::function<std::optional<std::string>(const std::string& name)>;

/// Geometry, number of pairs, angles, factors.
LampTilt read_tilt_factors(IesWords& words);

/// The same from the file that `name` names. One that is not to be had or is broken is a warning at
/// `line`: the luminaire can be used, its lamp's tilt is left out.
LampTilt read_tilt_file(const std::string& name, int line, const FileBeside& beside, LuminaireFindings& findings);

}  // namespace hanei
