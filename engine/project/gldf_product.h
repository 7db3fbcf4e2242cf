/// product.xml of a GLDF container.
#pragma once

#include "engine/project/gldf_file.h"
#include "engine/project/luminaire_findings.h"

#include <string_view>

namespace hanei {

/// What product.xml says, nothing of the container looked up: files know their names, photometries their
/// files. A text of several languages is taken in English, or in the first that is there.
///
/// Needs     decoded text (decoded_text).
/// Returns   a listing that means something when the findings hold no fault.
GldfListing read_gldf_product(std::string_view text, LuminaireFindings& findings);

}  // namespace hanei
