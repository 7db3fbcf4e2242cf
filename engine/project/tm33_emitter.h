/// One <Emitter> of a TM-33 file.
#pragma once

#include "engine/project/luminaire_findings.h"
#include "engine/project/tm33_areas.h"
#include "engine/scene/photometry.h"

#include <optional>
#include <pugixml.hpp>
#include <string>
#include <string_view>
#include <vector>

namespace hanei {

struct Tm33Emitter {
    std::string name;       ///< its description
    Photometry photometry;  ///< candela, or figures of unknown flux
    bool known = true;      ///< figures are candela
    std::optional<double> declared_flux;
    std::vector<Tm33Area> areas;
    bool has_centre = false;  ///< it lies off the middle of the luminaire
    int line = 0;             ///< of its first intensity
};

/// Intensities are IntData times Multiplier. Relative figures (AbsolutePhotometry false) are scaled by
/// RatedLumens: as cd/klm, or as candela of lamps of that flux when they hold more than 1100 lm, which
/// cd/klm of no luminaire do. The standard's own text was not at hand, so that a warning says which.
///
/// Needs     a photometric type, of the file's goniometer.
/// Returns   empty for an emitter without luminous intensities (of radiant or photon flux), or after a fault.
std::optional<Tm33Emitter> read_tm33_emitter(std::string_view text, const pugi::xml_node& node, PhotometricType type,
                                             LuminaireFindings& findings);

}  // namespace hanei
