#include "engine/project/text_file.h"

#include "engine/base/whole_file.h"

#include <fstream>
#include <system_error>

namespace hanei {
namespace {

constexpr std::uintmax_t most_bytes = 64U * 1024U * 1024U;

Diagnostic fault(const std::filesystem::path& file, const std::string& message) {
    return about_file(Severity::error, file.string(), 0, {}, message);
}

/// Why the file cannot be read, or nothing.
std::string refusal(const std::filesystem::path& file) {
    std::error_code error;
    const std::filesystem::file_status status = std::filesystem::status(file, error);
    if (!std::filesystem::exists(status)) return "there is no such file";
    if (std::filesystem::is_directory(status)) return "this is a folder, expected a file";
    if (!std::filesystem::is_regular_file(status)) return "this is no ordinary file";
    const std::uintmax_t size = std::filesystem::file_size(file, error);
    if (error) return "the file's size cannot be found: " + error.message();
    if (size > most_bytes)
        return "the file has " + std::to_string(size / (1024U * 1024U)) + " MB, at most 64 MB can be read";
    return {};
}

}  // namespace

Diagnostic about_file(Severity severity, const std::string& file, int line, const std::string& field,
                      const std::string& message) {
    Diagnostic finding;
    finding.severity = severity;
    finding.place.file = file;
    finding.place.line = line;
    finding.place.field = field;
    finding.message = message;
    return finding;
}

std::optional<std::string> read_text_file(const std::filesystem::path& file, Diagnostics& findings) {
    const std::string reason = refusal(file);
    if (!reason.empty()) {
        findings.push_back(fault(file, reason));
        return std::nullopt;
    }
    std::ifstream stream(file, std::ios::binary);
    std::string text{std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
    if (!stream.is_open() || stream.bad()) {
        findings.push_back(fault(file, "the file cannot be read; are you allowed to?"));
        return std::nullopt;
    }
    return text;
}

std::optional<Diagnostic> write_text_file(const std::filesystem::path& file, std::string_view text) {
    const std::optional<std::string> reason = write_whole_file(file, text);
    if (!reason) return std::nullopt;
    return fault(file, *reason);
}

}  // namespace hanei
