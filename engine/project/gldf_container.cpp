#include "engine/project/gldf_container.h"

#include "engine/project/number_text.h"

#include <algorithm>
#include <array>
#include <fmt/format.h>
#include <utility>
#include <zip.h>

namespace hanei {
namespace {

constexpr std::size_t most_in_all = 256U << 20U;

std::string with_slashes(std::string name) {
    std::replace(name.begin(), name.end(), '\\', '/');
    return name;
}

/// ASCII letters alone: the same on every machine and in every language.
std::string lower(std::string text) {
    for (char& c : text) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
    return text;
}

zip* opened(std::string_view bytes, std::string& reason) {
    zip_error_t error;
    zip_error_init(&error);
    zip_source_t* const source = zip_source_buffer_create(bytes.data(), bytes.size(), 0, &error);
    zip* const archive = source == nullptr ? nullptr : zip_open_from_source(source, ZIP_RDONLY, &error);
    if (archive == nullptr) {
        reason = zip_error_strerror(&error);
        zip_source_free(source);
    }
    zip_error_fini(&error);
    return archive;
}

struct CloseFile {
    void operator()(zip_file_t* file) const { zip_fclose(file); }
};

}  // namespace

void GldfContainer::Close::operator()(zip* archive) const { zip_discard(archive); }

GldfContainer::GldfContainer(std::string_view bytes, std::string_view name, Diagnostics& findings) : name_(name) {
    std::string reason;
    archive_.reset(opened(bytes, reason));
    if (!archive_) {
        findings.push_back(finding(Severity::error, "zip", "the file is no zip container or is cut short: " + reason));
        return;
    }
    list_entries(findings);
}

Diagnostic GldfContainer::finding(Severity severity, const std::string& field, std::string message) const {
    return {severity, {name_, field == "zip" ? 1 : 0, field, 0}, std::move(message)};
}

void GldfContainer::list_entries(Diagnostics& findings) {
    const auto count = static_cast<std::uint64_t>(std::max<zip_int64_t>(0, zip_get_num_entries(archive_.get(), 0)));
    bool backslashes = false;
    for (std::uint64_t place = 0; place < count; ++place) {
        const char* const found = zip_get_name(archive_.get(), place, ZIP_FL_ENC_GUESS);
        if (found == nullptr) continue;
        std::string entry = found;
        if (!stays_inside(entry)) {
            findings.push_back(finding(Severity::error, "entry name",
                                       in_quotes(entry) + " leads out of the container; the entry is not used"));
            continue;
        }
        backslashes = backslashes || entry.find('\\') != std::string::npos;
        entry = with_slashes(std::move(entry));
        if (entry.ends_with('/')) continue;
        const auto [position, is_new] = places_.insert_or_assign(entry, place);
        if (is_new) {
            lower_case_.emplace(lower(entry), entry);
            names_.push_back(std::move(entry));
        } else {
            findings.push_back(finding(Severity::warning, position->first, "stands twice; the last one is used"));
        }
    }
    if (backslashes)
        findings.push_back(finding(Severity::warning, "entry name", "backslashes are read as slashes between folders"));
}

std::optional<std::string> GldfContainer::find(const std::string& name, const std::string& field,
                                               Diagnostics& findings) const {
    const std::string entry = with_slashes(name);
    if (places_.contains(entry)) return entry;
    const std::string small = lower(entry);
    if (lower_case_.count(small) != 1) return std::nullopt;
    const std::string& found = lower_case_.find(small)->second;
    findings.push_back(finding(
        Severity::warning, field,
        fmt::format("{} is not in the container; {} is taken, though its letters differ in case", entry, found)));
    return found;
}

std::optional<std::string> GldfContainer::read(const std::string& entry, std::size_t most_bytes,
                                               Diagnostics& findings) {
    const auto refused = [&](std::string message) {
        findings.push_back(finding(Severity::error, entry, std::move(message)));
        return std::nullopt;
    };
    const auto place = places_.find(entry);
    if (place == places_.end()) return refused("is not in the container");
    zip_stat_t stat;
    zip_stat_init(&stat);
    if (zip_stat_index(archive_.get(), place->second, 0, &stat) != 0) return refused("its directory entry is damaged");
    if ((stat.valid & ZIP_STAT_ENCRYPTION_METHOD) != 0 && stat.encryption_method != ZIP_EM_NONE)
        return refused("is encrypted; containers are read without passwords");
    if ((stat.valid & ZIP_STAT_SIZE) != 0 && stat.size > most_bytes)
        return refused(fmt::format("{} bytes are declared; {} are allowed", stat.size, most_bytes));
    const std::unique_ptr<zip_file_t, CloseFile> file{zip_fopen_index(archive_.get(), place->second, 0)};
    if (!file) return refused(std::string{"cannot be opened: "} + zip_strerror(archive_.get()));
    std::string bytes;
    std::array<char, 65536> piece;
    zip_int64_t got = 0;
    while ((got = zip_fread(file.get(), piece.data(), piece.size())) > 0) {
        inflated_ += static_cast<std::size_t>(got);
        bytes.append(piece.data(), static_cast<std::size_t>(got));
        if (bytes.size() > most_bytes)
            return refused(fmt::format("inflates to more than the {} bytes that are allowed", most_bytes));
        if (inflated_ > most_in_all)
            return refused(
                fmt::format("the container inflates to more than the {} bytes that are allowed", most_in_all));
    }
    if (got < 0) return refused(std::string{"is damaged: "} + zip_file_strerror(file.get()));
    return bytes;
}

bool stays_inside(std::string_view name) {
    if (name.empty() || name.front() == '/' || name.front() == '\\') return false;
    if (name.size() > 1 && name[1] == ':') return false;
    const auto unprintable = [](char c) { return static_cast<unsigned char>(c) < ' ' || c == '\x7F'; };
    if (std::any_of(name.begin(), name.end(), unprintable)) return false;
    while (!name.empty()) {
        const std::size_t end = std::min(name.find_first_of("/\\"), name.size());
        if (name.substr(0, end) == "..") return false;
        name.remove_prefix(std::min(end + 1, name.size()));
    }
    return true;
}

bool looks_like_zip(std::string_view bytes) {
    return bytes.starts_with("PK\x03\x04") || bytes.starts_with("PK\x05\x06");
}

}  // namespace hanei
