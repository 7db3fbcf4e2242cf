/// Luminaire files: LM-63 (.ies) and EULUMDAT (.ldt), recognised by content.
#pragma once

#include "engine/base/diagnostic.h"
#include "engine/scene/photometry.h"

#include <filesystem>
#include <optional>
#include <string_view>

namespace hanei {

/// A luminaire's photometry, or why there is none.
struct LuminaireFileRead {
    std::optional<Photometry> photometry;
    Diagnostics findings;
};

/// Reads at most 16 MB; anything else is refused before it is read.
LuminaireFileRead read_luminaire_file(const std::filesystem::path& file);

/// `name` is what messages call the file.
LuminaireFileRead read_luminaire_text(std::string_view bytes, std::string_view name);

}  // namespace hanei
