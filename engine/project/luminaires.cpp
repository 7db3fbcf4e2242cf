#include "engine/project/luminaires.h"

#include "engine/project/gldf_container.h"
#include "engine/project/gldf_file.h"
#include "engine/project/gltf_lights.h"
#include "engine/project/luminaire_file.h"
#include "engine/project/luminaire_text.h"

#include <algorithm>
#include <cstdint>
#include <fmt/format.h>
#include <fstream>
#include <optional>
#include <system_error>
#include <utility>

namespace hanei {
namespace {

constexpr std::uintmax_t most_text_bytes = 16U << 20U;
constexpr std::uintmax_t most_bytes = 256U << 20U;  // containers bring pictures and models along

LuminairesRead named(LuminaireTextRead read) {
    LuminairesRead result{{}, std::move(read.findings)};
    for (Photometry& photometry : read.photometries) {
        std::string name = photometry.name;
        result.luminaires.push_back({std::move(name), std::move(photometry)});
    }
    return result;
}

/// By its first bytes; a damaged container by its name.
bool is_container(std::string_view bytes, std::string_view name) {
    constexpr std::string_view ending = ".GLDF";
    const std::size_t length = std::min(name.size(), ending.size());
    return looks_like_zip(bytes) || starts_with_word(name.substr(name.size() - length), ending);
}

std::optional<std::string> bytes_of(const std::filesystem::path& file, std::size_t most) {
    std::ifstream stream{file, std::ios::binary};
    std::string bytes(most, '\0');
    stream.read(bytes.data(), static_cast<std::streamsize>(most));
    if (stream.bad() || !stream.is_open()) return std::nullopt;
    bytes.resize(static_cast<std::size_t>(stream.gcount()));
    return bytes;
}

LuminairesRead unread(const std::filesystem::path& file, std::string message) {
    return {{}, {{Severity::error, {file.string(), 0, "file", 0}, std::move(message)}}};
}

LuminairesRead read_container(std::string_view bytes, std::string_view name) {
    GldfRead read = read_gldf(bytes, name);
    return {std::move(read.luminaires), std::move(read.findings)};
}

LuminairesRead read_scene(std::string_view bytes, std::string_view name, const GltfNeighbour& neighbour) {
    GltfRead read = read_gltf(bytes, name, neighbour);
    LuminairesRead result{{}, std::move(read.findings)};
    for (GltfLight& light : read.lights) result.luminaires.push_back(std::move(light.luminaire));
    return result;
}

}  // namespace

LuminairesRead read_luminaires(const std::filesystem::path& file) {
    std::error_code error;
    const std::uintmax_t size = std::filesystem::file_size(file, error);  // of a plain file: a pipe would wait
    if (error) return unread(file, "cannot be read: " + error.message());
    constexpr std::size_t head = 64;
    const std::optional<std::string> beginning = bytes_of(file, head);
    const bool scene = beginning && looks_like_gltf(*beginning);
    const bool container = beginning && is_container(*beginning, file.string());
    const std::uintmax_t most = scene || container ? most_bytes : most_text_bytes;
    if (size > most) return unread(file, fmt::format("{} bytes; {} can be read at most", size, most));
    const std::optional<std::string> bytes = bytes_of(file, static_cast<std::size_t>(size));
    if (!bytes) return unread(file, "cannot be read");
    if (scene) return read_scene(*bytes, file.string(), gltf_neighbours(file));
    if (container) return read_container(*bytes, file.string());
    LuminairesRead read = named(read_luminaire_texts(*bytes, file.string(), files_beside(file)));
    for (NamedPhotometry& luminaire : read.luminaires) {
        if (luminaire.name.empty()) luminaire.name = luminaire.photometry.name = file.stem().string();
    }
    return read;
}

LuminairesRead read_luminaires(std::string_view bytes, std::string_view name) {
    if (looks_like_gltf(bytes)) return read_scene(bytes, name, {});
    return is_container(bytes, name) ? read_container(bytes, name) : named(read_luminaire_texts(bytes, name));
}

}  // namespace hanei
