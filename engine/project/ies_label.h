/// The part of an LM-63 file before its numbers: version, keywords, TILT line.
#pragma once

#include "engine/project/luminaire_findings.h"

#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace hanei {

enum class IesVersion { v1986, v1991, v1995, v2002, v2019 };

std::string_view name_of(IesVersion version);  ///< "LM-63-2002"

struct IesLabel {
    IesVersion version = IesVersion::v1986;
    /// In file order, lines of [MORE] joined to theirs; lines without a keyword have an empty one.
    std::vector<std::pair<std::string, std::string>> keywords;
    std::string_view tilt;  ///< what follows TILT=
    int tilt_line = 0;
    std::string_view numbers;  ///< the text after the TILT line
};

/// A fault when there is no TILT line, or nothing on it.
IesLabel read_ies_label(std::string_view text, LuminaireFindings& findings);

/// True when a line of the text begins with TILT=, or its first with the name of the standard.
bool looks_like_ies(std::string_view text);

}  // namespace hanei
