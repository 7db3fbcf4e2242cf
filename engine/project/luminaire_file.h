/// Luminaire files of text: LM-63 (.ies), EULUMDAT (.ldt) and TM-33 (.xml), recognised by content.
#pragma once

#include "engine/base/diagnostic.h"
#include "engine/project/ies_tilt.h"
#include "engine/scene/photometry.h"

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace hanei {

/// A luminaire's photometry, or why there is none.
struct LuminaireFileRead {
    std::optional<Photometry> photometry;
    Diagnostics findings;
};

/// All photometries of a text: one, but for TM-33 files whose emitters cannot be summed.
struct LuminaireTextRead {
    std::vector<Photometry> photometries;  ///< empty when the text cannot be used
    Diagnostics findings;
};

/// Reads at most 16 MB; anything else is refused before it is read. Looks for a file that is named in the
/// file's own folder alone, under its bare name.
LuminaireFileRead read_luminaire_file(const std::filesystem::path& file);

/// `name` is what messages call the file. A text of several photometries is refused.
LuminaireFileRead read_luminaire_text(std::string_view bytes, std::string_view name, const FileBeside& beside = {});

LuminaireTextRead read_luminaire_texts(std::string_view bytes, std::string_view name, const FileBeside& beside = {});

/// The files in the folder of `file`. A name with a folder, a drive or unprintable bytes in it is not
/// looked for, nor what is no plain file of 1 MB at most.
FileBeside files_beside(const std::filesystem::path& file);

}  // namespace hanei
