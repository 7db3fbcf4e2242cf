/// TM-33 files (.xml, ANSI/IES TM-33-18, -22, -23): one emitter with absolute photometry.
#pragma once

#include "engine/project/luminaire_findings.h"
#include "engine/scene/photometry.h"

#include <string_view>

namespace hanei {

/// Candela are the values of IntData times the multiplier. Radiant and photon quantities are other
/// light and never read as candela. Files of several emitters and relative values are refused.
///
/// Needs     decoded text (decoded_text).
/// Returns   a photometry that means something when the findings hold no fault.
Photometry read_tm33(std::string_view text, LuminaireFindings& findings);

bool looks_like_tm33(std::string_view text);

}  // namespace hanei
