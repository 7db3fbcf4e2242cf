/// TM-33 files (.xml, ANSI/IES TM-33-18, -22, -23), and ATLA S001, which they grew from.
#pragma once

#include "engine/project/luminaire_findings.h"
#include "engine/scene/photometry.h"

#include <string_view>
#include <vector>

namespace hanei {

/// Emitters share the frame of the file's goniometer, so that their intensities add up (photometric_sum.h)
/// and the luminaire is one photometry. Emitters of which some are in figures of unknown flux (relative,
/// without RatedLumens) cannot be summed: each becomes a photometry of its own. Radiant and photon
/// quantities are other light and never read as candela: an emitter of them alone is left out.
///
/// Lengths lie along plane 90 when the goniometer is of the CIE, along plane 0 when it is of the IES.
///
/// Needs     decoded text (decoded_text).
/// Returns   photometries that mean something when the findings hold no fault; then one or more.
std::vector<Photometry> read_tm33(std::string_view text, LuminaireFindings& findings);

bool looks_like_tm33(std::string_view text);

}  // namespace hanei
