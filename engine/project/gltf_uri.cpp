#include "engine/project/gltf_uri.h"

#include "engine/project/gldf_container.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <fstream>
#include <system_error>
#include <utility>

namespace hanei {
namespace {

/// 64 for a character that stands for no six bits.
std::uint32_t six_bits(char c) {
    if (c >= 'A' && c <= 'Z') return static_cast<std::uint32_t>(c - 'A');
    if (c >= 'a' && c <= 'z') return static_cast<std::uint32_t>(c - 'a') + 26;
    if (c >= '0' && c <= '9') return static_cast<std::uint32_t>(c - '0') + 52;
    return c == '+' ? 62 : c == '/' ? 63 : 64;
}

std::optional<std::string> base64_decoded(std::string_view text) {
    while (text.ends_with('=')) text.remove_suffix(1);
    if (text.size() % 4 == 1) return std::nullopt;
    std::string bytes;
    bytes.reserve(text.size() / 4 * 3 + 2);
    std::uint32_t bits = 0;
    int count = 0;
    for (const char c : text) {
        const std::uint32_t six = six_bits(c);
        if (six > 63) return std::nullopt;
        bits = (bits << 6U | six) & 0xFFFFU;
        count += 6;
        if (count < 8) continue;
        count -= 8;
        bytes.push_back(static_cast<char>(bits >> count & 0xFFU));
    }
    return bytes;
}

/// 16 for a character that is no hexadecimal digit.
int hex_digit(char c) {
    if (c >= '0' && c <= '9') return c - '0';
    if (c >= 'a' && c <= 'f') return c - 'a' + 10;
    return c >= 'A' && c <= 'F' ? c - 'A' + 10 : 16;
}

std::optional<std::string> percent_decoded(std::string_view text) {
    std::string bytes;
    for (std::size_t k = 0; k < text.size(); ++k) {
        if (text[k] != '%') {
            bytes.push_back(text[k]);
            continue;
        }
        if (text.size() - k < 3) return std::nullopt;
        const int high = hex_digit(text[k + 1]);
        const int low = hex_digit(text[k + 2]);
        if (high > 15 || low > 15) return std::nullopt;
        bytes.push_back(static_cast<char>(high * 16 + low));
        k += 2;
    }
    return bytes;
}

bool lies_below(const std::filesystem::path& folder, const std::filesystem::path& file) {
    const auto [end, rest] = std::mismatch(folder.begin(), folder.end(), file.begin(), file.end());
    return end == folder.end();
}

}  // namespace

GltfNeighbour gltf_neighbours(const std::filesystem::path& file) {
    return [folder = file.parent_path()](const std::string& name) -> std::optional<std::string> {
        constexpr std::uintmax_t most = 256U << 20U;
        std::error_code error;
        const std::filesystem::path home = std::filesystem::canonical(folder.empty() ? "." : folder, error);
        if (error) return std::nullopt;
        const std::filesystem::path wanted = std::filesystem::canonical(home / name, error);
        if (error || !lies_below(home, wanted) || !std::filesystem::is_regular_file(wanted, error)) return std::nullopt;
        const std::uintmax_t size = std::filesystem::file_size(wanted, error);
        if (error || size > most) return std::nullopt;
        std::string bytes(static_cast<std::size_t>(size), '\0');
        std::ifstream stream{wanted, std::ios::binary};
        stream.read(bytes.data(), static_cast<std::streamsize>(bytes.size()));
        return stream ? std::optional{std::move(bytes)} : std::nullopt;
    };
}

std::optional<std::string> data_uri_bytes(std::string_view uri) {
    constexpr std::string_view scheme = "data:";
    constexpr std::string_view encoding = ";base64";
    const std::size_t comma = uri.find(',');
    if (!uri.starts_with(scheme) || comma == std::string_view::npos) return std::nullopt;
    if (!uri.substr(0, comma).ends_with(encoding)) return std::nullopt;
    return base64_decoded(uri.substr(comma + 1));
}

std::optional<std::string> neighbour_name(std::string_view uri) {
    const std::size_t colon = uri.find(':');
    const bool has_scheme = colon != std::string_view::npos && uri.find('/') > colon;
    if (has_scheme) return std::nullopt;
    std::optional<std::string> name = percent_decoded(uri);
    return name && stays_inside(*name) ? name : std::nullopt;
}

}  // namespace hanei
