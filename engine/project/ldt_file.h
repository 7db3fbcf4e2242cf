/// EULUMDAT files (.ldt).
#pragma once

#include "engine/project/luminaire_findings.h"
#include "engine/scene/photometry.h"

#include <string_view>

namespace hanei {

/// Candela are the file's cd/klm times the flux of the first lamp set, which already holds the
/// luminaire's losses. Plane 0 is across the lamps: the length of the opening lies along plane 90.
///
/// Needs     decoded text (decoded_text).
/// Returns   a photometry that means something when the findings hold no fault. Name of the file and
///           warnings are for the caller to set.
Photometry read_ldt(std::string_view text, LuminaireFindings& findings);

/// True when the second to sixth line are the numbers that every EULUMDAT file has there.
bool looks_like_ldt(std::string_view text);

}  // namespace hanei
