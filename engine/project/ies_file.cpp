#include "engine/project/ies_file.h"

#include "engine/project/ies_label.h"
#include "engine/project/ies_opening.h"
#include "engine/project/ies_words.h"
#include "engine/project/luminaire_text.h"
#include "engine/project/number_text.h"
#include "engine/project/photometric_table.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <fmt/format.h>

namespace hanei {
namespace {

constexpr double metres_per_foot = 0.3048;
/// A file of 16 MB has room for no more numbers than this: two characters each.
constexpr double most_values = 8'388'608.0;

constexpr AllowedRange count_of_angles{1.0, most_values, "a whole number from 1 to what a file can hold"};
constexpr AllowedRange not_negative{0.0, 1e30, "0 or more"};

/// The numbers between the TILT data and the angles.
struct IesHeader {
    double factor = 1.0;  ///< from the file's figures to candela
    int verticals = 0;
    int horizontals = 0;
};

void read_tilt(const IesLabel& label, const FileBeside& beside, IesWords& words, Photometry& photometry,
               LuminaireFindings& findings) {
    if (starts_with_word(label.tilt, "NONE")) return;
    photometry.tilt = starts_with_word(label.tilt, "INCLUDE")
                          ? read_tilt_factors(words)
                          : read_tilt_file(utf8_text(label.tilt), label.tilt_line, beside, findings);
}

void read_lamps(IesWords& words, Photometry& photometry, LuminaireFindings& findings) {
    photometry.lamps = words.whole("number of lamps", {0.0, 1e6, "a whole number from 0"});
    const double lumens = words.number("lumens per lamp");
    if (lumens < 0.0) {
        photometry.absolute = true;
        if (lumens != -1.0) {
            findings.warn(words.line(), "lumens per lamp",
                          fmt::format("{} found; read as -1, absolute photometry", lumens));
        }
        return;
    }
    photometry.lamp_lumens = lumens * photometry.lamps;
    if (photometry.lamps == 0) findings.warn(words.line(), "number of lamps", "0: the light output ratio is unknown");
}

void read_opening(IesVersion version, IesWords& words, Photometry& photometry, LuminaireFindings& findings) {
    const bool feet = words.whole("units type", {1.0, 2.0, "1 (feet) or 2 (metres)"}) == 1;
    const double unit = feet ? metres_per_foot : 1.0;
    IesDimensions size;
    size.width = unit * words.number("width");
    const int line = words.line();
    size.length = unit * words.number("length");
    size.height = unit * words.number("height");
    if (const auto opening = ies_opening(size, version <= IesVersion::v1995)) {
        photometry.opening = *opening;
    } else {
        photometry.opening = {OpeningShape::point, std::abs(size.length), std::abs(size.width), std::abs(size.height)};
        findings.warn(line, "luminous opening",
                      fmt::format("width {}, length {}, height {} m stand for no shape; read as a point", size.width,
                                  size.length, size.height));
    }
    check_opening(photometry.opening, line, findings);
}

/// Number of lamps to input watts: the ten numbers and the three after them.
IesHeader read_header(IesVersion version, IesWords& words, Photometry& photometry, LuminaireFindings& findings) {
    IesHeader header;
    read_lamps(words, photometry, findings);
    const double multiplier = words.number("candela multiplier", not_negative);
    if (multiplier == 0.0) findings.warn(words.line(), "candela multiplier", "0: the luminaire is dark");
    header.verticals = words.whole("number of vertical angles", count_of_angles);
    if (header.verticals == 1) {
        findings.fault(words.line(), "number of vertical angles", "1 found; a distribution needs 2 or more");
    }
    header.horizontals = words.whole("number of horizontal angles", count_of_angles);
    if (static_cast<double>(header.verticals) * header.horizontals > most_values) {
        findings.fault(
            words.line(), "number of angles",
            fmt::format("{} x {} values are more than a file can hold", header.verticals, header.horizontals));
    }
    const int type = words.whole("photometric type", {1.0, 3.0, "1 (C), 2 (B) or 3 (A)"});
    photometry.type = type == 3 ? PhotometricType::A : type == 2 ? PhotometricType::B : PhotometricType::C;
    read_opening(version, words, photometry, findings);
    const double ballast = words.number("ballast factor", not_negative);
    const double ballast_lamp = words.number("ballast-lamp factor or file type");
    header.factor = multiplier * ballast * (version <= IesVersion::v1991 ? ballast_lamp : 1.0);
    photometry.input_watts = words.number("input watts");
    return header;
}

AllowedRange vertical_range(PhotometricType type) {
    switch (type) {
        case PhotometricType::A:
            return {-90.0, 90.0, "-90 to 90 degrees"};
        case PhotometricType::B:
            return {-180.0, 180.0, "-180 to 180 degrees"};
        case PhotometricType::C:
            break;
    }
    return {0.0, 180.0, "0 to 180 degrees"};
}

AllowedRange horizontal_range(PhotometricType type) {
    switch (type) {
        case PhotometricType::A:
            return {-180.0, 180.0, "-180 to 180 degrees"};
        case PhotometricType::B:
            return {-90.0, 90.0, "-90 to 90 degrees"};
        case PhotometricType::C:
            break;
    }
    return {-180.0, 360.0, "0 to 360 degrees"};
}

void read_table(const IesHeader& header, IesWords& words, Photometry& photometry, LuminaireFindings& findings) {
    const auto verticals = static_cast<std::size_t>(header.verticals);
    const auto horizontals = static_cast<std::size_t>(header.horizontals);
    photometry.vertical_deg = words.increasing(verticals, "vertical angle", vertical_range(photometry.type));
    photometry.horizontal_deg = words.increasing(horizontals, "horizontal angle", horizontal_range(photometry.type));
    if (findings.failed()) return;
    const auto symmetry = symmetry_of(photometry.type, photometry.horizontal_deg, words.line(), findings);
    if (!symmetry) return;
    photometry.symmetry = *symmetry;
    const int line = words.next_line();
    set_candela(photometry, words.numbers(verticals * horizontals, "candela"), header.factor, line, findings);
    if (!findings.failed() && words.left() > 0) {
        findings.warn(words.next_line(), "end of data",
                      fmt::format("{} words follow the last candela figure and are not read", words.left()));
    }
}

const std::string* keyword(const Photometry& photometry, std::string_view name) {
    for (const auto& [key, text] : photometry.keywords) {
        if (key == name && !text.empty()) return &text;
    }
    return nullptr;
}

void warn_of_other_quantities(const Photometry& photometry, int line, LuminaireFindings& findings) {
    const std::string* units = keyword(photometry, "_INTENSITYUNITS");
    if (units == nullptr || *units == "cd") return;
    findings.warn(line, "_INTENSITYUNITS",
                  "the figures are in " + in_quotes(*units) + ", not candela: this is no visible light");
}

}  // namespace

Photometry read_ies(std::string_view text, const FileBeside& beside, LuminaireFindings& findings) {
    Photometry photometry;
    const std::size_t end_of_file = text.find('\x1A');  // as DOS wrote it behind the last line
    IesLabel label = read_ies_label(text.substr(0, end_of_file), findings);
    if (findings.failed()) return photometry;
    photometry.format = name_of(label.version);
    photometry.keywords = std::move(label.keywords);
    IesWords words{label.numbers, label.tilt_line + 1, findings};
    read_tilt(label, beside, words, photometry, findings);
    const IesHeader header = read_header(label.version, words, photometry, findings);
    read_table(header, words, photometry, findings);
    warn_of_other_quantities(photometry, label.tilt_line, findings);
    for (const std::string_view key : {"LUMINAIRE", "LUMCAT"}) {
        const std::string* found = keyword(photometry, key);
        if (photometry.name.empty() && found != nullptr) photometry.name = found->substr(0, found->find('\n'));
    }
    return photometry;
}

}  // namespace hanei
