#include "engine/project/ies_tilt.h"

#include "engine/project/ies_words.h"
#include "engine/project/luminaire_text.h"
#include "engine/project/number_text.h"

#include <cstddef>

namespace hanei {
namespace {

constexpr double most_pairs = 4'194'304.0;  // two numbers of two characters each fill a file of 16 MB

}  // namespace

LampTilt read_tilt_factors(IesWords& words) {
    LampTilt tilt;
    tilt.geometry = words.whole("lamp-to-luminaire geometry", {1.0, 3.0, "1, 2 or 3"});
    const int pairs = words.whole("number of tilt pairs", {1.0, most_pairs, "a whole number from 1"});
    tilt.angle_deg = words.increasing(static_cast<std::size_t>(pairs), "tilt angle", {-360.0, 360.0, "an angle"});
    tilt.factor = words.numbers(static_cast<std::size_t>(pairs), "tilt factor");
    return tilt;
}

LampTilt read_tilt_file(const std::string& name, int line, const FileBeside& beside, LuminaireFindings& findings) {
    LampTilt tilt;
    const std::optional<std::string> bytes = beside ? beside(name) : std::nullopt;
    if (bytes) {
        LuminaireFindings own{name};
        const std::string text = decoded_text(*bytes);
        IesWords words{text, 1, own};
        tilt = read_tilt_factors(words);
        if (own.failed()) {
            findings.warn(line, "TILT", to_text(own.diagnostics().back()) + "; the lamp's tilt is left out");
            tilt = {};
        }
    } else {
        findings.warn(
            line, "TILT",
            in_quotes(name) + " is a file of its own and is not beside this one; the lamp's tilt is left out");
    }
    tilt.file = name;
    return tilt;
}

}  // namespace hanei
