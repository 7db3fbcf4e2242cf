#include "engine/project/ies_label.h"

#include "engine/project/luminaire_text.h"
#include "engine/project/number_text.h"

#include <fmt/format.h>
#include <optional>

namespace hanei {
namespace {

/// What follows "TILT =" on its line.
std::optional<std::string_view> tilt_of(std::string_view line) {
    line = trimmed(line);
    if (!starts_with_word(line, "TILT")) return std::nullopt;
    line = trimmed(line.substr(4));
    if (!line.starts_with('=')) return std::nullopt;
    return trimmed(line.substr(1));
}

bool names_the_standard(std::string_view line) { return starts_with_word(trimmed(line), "IES"); }

/// By the year at the end of the first word: IESNA91, IESNA95, IESNA:LM-63-2002, IES:LM-63-2019.
IesVersion version_of(std::string_view line, int number, LuminaireFindings& findings) {
    struct Year {
        std::string_view digits;
        IesVersion version;
    };
    static constexpr Year years[] = {{"2019", IesVersion::v2019}, {"2002", IesVersion::v2002},
                                     {"1995", IesVersion::v1995}, {"1991", IesVersion::v1991},
                                     {"1986", IesVersion::v1986}, {"NA95", IesVersion::v1995},
                                     {"NA91", IesVersion::v1991}, {"NA86", IesVersion::v1986}};
    for (const Year& year : years) {
        if (line.find(year.digits) != std::string_view::npos) return year.version;
    }
    findings.warn(number, "version", in_quotes(trimmed(line)) + " is no known version; read as LM-63-2002");
    return IesVersion::v2002;
}

struct Keyword {
    std::string_view name;
    std::string_view text;
};

std::optional<Keyword> keyword_of(std::string_view line) {
    line = trimmed(line);
    const std::size_t end = line.find(']');
    if (!line.starts_with('[') || end == std::string_view::npos) return std::nullopt;
    return Keyword{trimmed(line.substr(1, end - 1)), trimmed(line.substr(end + 1))};
}

void append_line(IesLabel& label, std::string_view line) {
    const std::optional<Keyword> keyword = keyword_of(line);
    if (keyword && starts_with_word(keyword->name, "MORE") && !label.keywords.empty()) {
        label.keywords.back().second += '\n' + utf8_text(keyword->text);
    } else if (keyword) {
        label.keywords.emplace_back(utf8_text(keyword->name), utf8_text(keyword->text));
    } else if (!trimmed(line).empty()) {
        label.keywords.emplace_back("", utf8_text(trimmed(line)));
    }
}

}  // namespace

std::string_view name_of(IesVersion version) {
    switch (version) {
        case IesVersion::v1986:
            return "LM-63-1986";
        case IesVersion::v1991:
            return "LM-63-1991";
        case IesVersion::v1995:
            return "LM-63-1995";
        case IesVersion::v2002:
            return "LM-63-2002";
        case IesVersion::v2019:
            break;
    }
    return "LM-63-2019";
}

IesLabel read_ies_label(std::string_view text, LuminaireFindings& findings) {
    IesLabel label;
    LineReader lines{text};
    bool first = true;
    while (lines.next()) {
        if (const auto tilt = tilt_of(lines.line())) {
            label.tilt = *tilt;
            label.tilt_line = lines.number();
            label.numbers = lines.rest();
            if (tilt->empty()) {
                findings.fault(lines.number(), "TILT", "nothing follows TILT=; NONE, INCLUDE or a file name is needed");
            }
            return label;
        }
        if (trimmed(lines.line()).empty()) continue;
        if (first && names_the_standard(lines.line())) {
            label.version = version_of(lines.line(), lines.number(), findings);
        } else {
            append_line(label, lines.line());
        }
        first = false;
    }
    findings.fault(1, "TILT", fmt::format("no line of {} begins with TILT=: this is no LM-63 file", lines.number()));
    return label;
}

bool looks_like_ies(std::string_view text) {
    LineReader lines{text};
    bool first = true;
    while (lines.next()) {
        if (trimmed(lines.line()).empty()) continue;
        if ((first && names_the_standard(lines.line())) || tilt_of(lines.line())) return true;
        first = false;
    }
    return false;
}

}  // namespace hanei
