/// LM-63 files (.ies) of 1986, 1991, 1995, 2002 and 2019 (IES LM-63; facts checked on measured files).
#pragma once

#include "engine/project/ies_tilt.h"
#include "engine/project/luminaire_findings.h"
#include "engine/scene/photometry.h"

#include <string_view>

namespace hanei {

/// Candela are the file's figures times multiplier and ballast factor, and until 1991 the ballast-lamp
/// factor. TILT factors are kept, not applied here; a file of them is asked for `beside` this one.
///
/// Needs     decoded text (decoded_text).
/// Returns   a photometry that means something when the findings hold no fault. Id, name of the file
///           and warnings are for the caller to set.
Photometry read_ies(std::string_view text, const FileBeside& beside, LuminaireFindings& findings);

}  // namespace hanei
