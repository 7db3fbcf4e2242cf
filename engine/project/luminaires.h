/// Every luminaire a file holds, whatever its format: the one door for files a designer brings.
#pragma once

#include "engine/base/diagnostic.h"
#include "engine/scene/photometry.h"

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace hanei {

/// One of the luminaires of a file. In a container two of them may share a photometry's name.
struct NamedPhotometry {
    std::string name;  ///< what a list of the file's luminaires calls it: the luminaire, or "variant / emitter"
    Photometry photometry;
};

struct LuminairesRead {
    std::vector<NamedPhotometry> luminaires;  ///< empty when the file cannot be used
    Diagnostics findings;
};

/// Recognises the format by content: LM-63 and EULUMDAT hold one luminaire, TM-33 one but
/// where its emitters cannot be summed, GLDF containers and glTF scenes any number. At most 16 MB of text,
/// 256 MB of a container or scene.
///
/// Returns   what can be used. A container keeps its good luminaires when another one is broken: the
///           findings then hold errors beside luminaires.
LuminairesRead read_luminaires(const std::filesystem::path& file);

/// The same for bytes at hand. `name` is what messages call the file; nothing else is read.
LuminairesRead read_luminaires(std::string_view bytes, std::string_view name);

}  // namespace hanei
