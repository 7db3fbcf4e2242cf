#include "engine/project/luminaire_file.h"

#include "engine/project/gldf_container.h"
#include "engine/project/ies_file.h"
#include "engine/project/ies_label.h"
#include "engine/project/ldt_file.h"
#include "engine/project/luminaire_findings.h"
#include "engine/project/luminaire_text.h"
#include "engine/project/tm33_file.h"

#include <algorithm>
#include <cstdint>
#include <fmt/format.h>
#include <fstream>
#include <string>
#include <system_error>

namespace hanei {
namespace {

constexpr std::uintmax_t most_bytes = 16U << 20U;

/// A NUL byte stands in no text file. One in the first bytes means that the whole is something else.
bool refuse_binary(std::string_view text, LuminaireFindings& findings) {
    const std::size_t nul = text.find('\0');
    if (nul == std::string_view::npos) return false;
    constexpr std::size_t head = 64;
    if (nul < head) {
        findings.fault(1, "file", "binary data; a luminaire file is text");
        return true;
    }
    LineReader lines{text};
    while (lines.next() && lines.line().find('\0') == std::string_view::npos) continue;
    findings.fault(lines.number(), "file", "a NUL byte stands in the text; the file is damaged");
    return true;
}

bool named(std::string_view name, std::string_view upper_case_ending) {
    const std::size_t length = std::min(name.size(), upper_case_ending.size());
    return starts_with_word(name.substr(name.size() - length), upper_case_ending);
}

void warn_of_other_name(std::string_view format, LuminaireFindings& findings) {
    findings.warn(1, "file", fmt::format("the content is {}, whatever the name of the file says", format));
}

std::vector<Photometry> alone(Photometry photometry) {
    std::vector<Photometry> one;
    one.push_back(std::move(photometry));
    return one;
}

std::vector<Photometry> read_by_content(std::string_view text, std::string_view name, const FileBeside& beside,
                                        LuminaireFindings& findings) {
    if (looks_like_tm33(text)) return read_tm33(text, findings);
    if (looks_like_ies(text)) {
        if (named(name, ".LDT")) warn_of_other_name("LM-63", findings);
        return alone(read_ies(text, beside, findings));
    }
    if (looks_like_ldt(text) || named(name, ".LDT")) {
        if (named(name, ".IES")) warn_of_other_name("EULUMDAT", findings);
        return alone(read_ldt(text, findings));
    }
    return alone(read_ies(text, beside, findings));
}

bool is_utf16(std::string_view bytes) { return bytes.starts_with("\xFF\xFE") || bytes.starts_with("\xFE\xFF"); }

LuminaireFileRead unread(const std::filesystem::path& file, std::string message) {
    return {std::nullopt, {{Severity::error, {file.string(), 0, "file", 0}, std::move(message)}}};
}

}  // namespace

LuminaireFileRead read_luminaire_file(const std::filesystem::path& file) {
    std::error_code error;
    const std::uintmax_t size = std::filesystem::file_size(file, error);
    if (error) return unread(file, "cannot be read: " + error.message());
    if (size > most_bytes) return unread(file, fmt::format("{} bytes; a luminaire file has 16 MB at most", size));
    std::string bytes(static_cast<std::size_t>(size), '\0');
    std::ifstream stream{file, std::ios::binary};
    stream.read(bytes.data(), static_cast<std::streamsize>(bytes.size()));
    if (!stream) return unread(file, "cannot be read");
    LuminaireFileRead read = read_luminaire_text(bytes, file.string(), files_beside(file));
    if (read.photometry && read.photometry->name.empty()) read.photometry->name = file.stem().string();
    return read;
}

LuminaireFileRead read_luminaire_text(std::string_view bytes, std::string_view name, const FileBeside& beside) {
    LuminaireTextRead read = read_luminaire_texts(bytes, name, beside);
    if (read.photometries.size() == 1) return {std::move(read.photometries.front()), std::move(read.findings)};
    if (!read.photometries.empty()) {
        read.findings.push_back(
            {Severity::error,
             {std::string{name}, 1, "Emitter", 0},
             fmt::format("{} luminaires stand in the file, of which one must be chosen", read.photometries.size())});
    }
    return {std::nullopt, std::move(read.findings)};
}

LuminaireTextRead read_luminaire_texts(std::string_view bytes, std::string_view name, const FileBeside& beside) {
    LuminaireFindings findings{name};
    const std::string text = decoded_text(bytes);
    if (trimmed(text).empty()) findings.fault(1, "file", "the file is empty");
    if (is_utf16(bytes)) findings.warn(1, "file", "the text is UTF-16; other programs may not read it");
    std::vector<Photometry> photometries;
    if (!findings.failed() && !refuse_binary(text, findings))
        photometries = read_by_content(text, name, beside, findings);
    if (findings.failed()) return {{}, findings.diagnostics()};
    for (Photometry& photometry : photometries) {
        photometry.source_file = std::filesystem::path{name}.filename().string();
        photometry.warnings = findings.warning_texts();
    }
    return {std::move(photometries), findings.diagnostics()};
}

FileBeside files_beside(const std::filesystem::path& file) {
    return [folder = file.parent_path()](const std::string& name) -> std::optional<std::string> {
        constexpr std::uintmax_t most = 1U << 20U;
        const bool bare = stays_inside(name) && name.find_first_of("/\\:") == std::string::npos;
        std::error_code error;
        const std::filesystem::path beside = folder / name;
        if (!bare || !std::filesystem::is_regular_file(beside, error)) return std::nullopt;
        const std::uintmax_t size = std::filesystem::file_size(beside, error);
        if (error || size > most) return std::nullopt;
        std::string text(static_cast<std::size_t>(size), '\0');
        std::ifstream stream{beside, std::ios::binary};
        stream.read(text.data(), static_cast<std::streamsize>(text.size()));
        return stream ? std::optional{std::move(text)} : std::nullopt;
    };
}

}  // namespace hanei
