#include "engine/project/gltf_writer.h"

#include "engine/project/json_text.h"
#include "engine/project/project_writer.h"

#include <algorithm>
#include <cmath>
#include <cstring>

namespace hanei {
namespace {

constexpr int of_shorts = 5123, of_words = 5125, of_floats = 5126;  // component types
constexpr int for_vertices = 34962, for_indices = 34963;

/// As the machine holds it: glTF is little-endian, as is every machine this is built for.
template <class T>
void append(std::string& bytes, T value) {
    std::array<char, sizeof(T)> raw{};
    std::memcpy(raw.data(), &value, sizeof value);
    bytes.append(raw.data(), raw.size());
}

void pad(std::string& bytes, char with) {
    while (bytes.size() % 4 != 0) bytes.push_back(with);
}

JsonValue json_of_single(const Vec3& place) {
    return json_of(Vec3{static_cast<float>(place.x), static_cast<float>(place.y), static_cast<float>(place.z)});
}

}  // namespace

GltfWriter::GltfWriter(std::string_view generator) : root_(json_object()) {
    JsonValue& asset = root_.add("asset", json_object());
    asset.add("version", json_text("2.0"));
    asset.add("generator", json_text(std::string(generator)));
}

JsonValue& GltfWriter::list(const std::string& name) {
    for (std::size_t k = 0; k < root_.keys.size(); ++k)
        if (root_.keys[k] == name) return root_.items[k];
    return root_.add(name, json_list());
}

int GltfWriter::add(const std::string& name, JsonValue item) {
    JsonValue& items = list(name);
    items.items.push_back(std::move(item));
    return static_cast<int>(items.items.size()) - 1;
}

void GltfWriter::use_extension(const std::string& name) {
    JsonValue& used = list("extensionsUsed");
    const bool known =
        std::any_of(used.items.begin(), used.items.end(), [&](const JsonValue& other) { return other.text == name; });
    if (!known) used.items.push_back(json_text(name));
}

int GltfWriter::add_bytes(std::string_view bytes) { return add("bufferViews", view_of(bytes)); }

JsonValue GltfWriter::view_of(std::string_view bytes) {
    pad(bytes_, '\0');
    JsonValue view = json_object();
    view.add("buffer", json_number(0));
    view.add("byteOffset", json_number(static_cast<double>(bytes_.size())));
    view.add("byteLength", json_number(static_cast<double>(bytes.size())));
    bytes_ += bytes;
    return view;
}

int GltfWriter::add_accessor(const std::string& bytes, int component, std::size_t count, const char* type, int target,
                             JsonValue bounds) {
    JsonValue view = view_of(bytes);
    view.add("target", json_number(target));
    JsonValue accessor = json_object();
    accessor.add("bufferView", json_number(add("bufferViews", std::move(view))));
    accessor.add("componentType", json_number(component));
    accessor.add("count", json_number(static_cast<double>(count)));
    accessor.add("type", json_text(type));
    for (std::size_t k = 0; k < bounds.keys.size(); ++k) accessor.add(bounds.keys[k], std::move(bounds.items[k]));
    return add("accessors", std::move(accessor));
}

int GltfWriter::add_places(std::span<const Vec3> places) {
    std::string bytes;
    Vec3 low = places.empty() ? Vec3{0.0} : places[0], high = low;
    for (const Vec3& place : places) {
        low = glm::min(low, place);
        high = glm::max(high, place);
        for (int axis = 0; axis < 3; ++axis) append(bytes, static_cast<float>(place[axis]));
    }
    JsonValue bounds = json_object();
    bounds.add("min", json_of_single(low));
    bounds.add("max", json_of_single(high));
    return add_accessor(bytes, of_floats, places.size(), "VEC3", for_vertices, std::move(bounds));
}

int GltfWriter::add_colours(std::span<const std::array<float, 3>> colours) {
    constexpr float most = 65535.0F;
    std::string bytes;
    for (const std::array<float, 3>& colour : colours) {
        for (const float band : colour)
            append(bytes, static_cast<std::uint16_t>(std::lround(most * std::clamp(band, 0.0F, 1.0F))));
        append(bytes, static_cast<std::uint16_t>(most));
    }
    JsonValue normalised = json_object();
    normalised.add("normalized", json_boolean(true));
    return add_accessor(bytes, of_shorts, colours.size(), "VEC4", for_vertices, std::move(normalised));
}

int GltfWriter::add_indices(std::span<const std::uint32_t> indices) {
    constexpr std::uint32_t most = 65534;  // the greatest 16 bit number is kept for other uses
    const bool large = std::any_of(indices.begin(), indices.end(), [](std::uint32_t k) { return k > most; });
    std::string bytes;
    for (const std::uint32_t index : indices) {
        if (large)
            append(bytes, index);
        else
            append(bytes, static_cast<std::uint16_t>(index));
    }
    return add_accessor(bytes, large ? of_words : of_shorts, indices.size(), "SCALAR", for_indices, json_object());
}

JsonValue GltfWriter::finished(bool with_uri) {
    JsonValue root = root_;
    if (bytes_.empty()) return root;
    JsonValue buffer = json_object();
    buffer.add("byteLength", json_number(static_cast<double>(bytes_.size())));
    if (with_uri) buffer.add("uri", json_text("data:application/octet-stream;base64," + base64(bytes_)));
    root.add("buffers", json_list()).items.push_back(std::move(buffer));
    return root;
}

std::string GltfWriter::text() { return json_document(finished(true)); }

std::string GltfWriter::binary() {
    std::string json = one_line(finished(false));
    pad(json, ' ');
    pad(bytes_, '\0');
    constexpr std::uint32_t header = 12, chunk_header = 8;
    const auto chunk = [](std::size_t size) { return static_cast<std::uint32_t>(size); };
    std::string file = "glTF";
    append(file, std::uint32_t{2});
    append(file,
           header + chunk_header + chunk(json.size()) + (bytes_.empty() ? 0 : chunk_header + chunk(bytes_.size())));
    append(file, chunk(json.size()));
    file += "JSON" + json;
    if (bytes_.empty()) return file;
    append(file, chunk(bytes_.size()));
    file += std::string("BIN\0", 4) + bytes_;
    return file;
}

std::string base64(std::string_view bytes) {
    constexpr std::string_view digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string text;
    text.reserve(bytes.size() / 3 * 4 + 4);
    for (std::size_t k = 0; k < bytes.size(); k += 3) {
        std::uint32_t bits = 0;
        for (std::size_t j = 0; j < 3; ++j)
            bits = bits << 8U | (k + j < bytes.size() ? static_cast<unsigned char>(bytes[k + j]) : 0U);
        for (std::size_t j = 0; j < 4; ++j)
            text.push_back(j <= bytes.size() - k ? digits[bits >> (18U - 6U * j) & 63U] : '=');
    }
    return text;
}

}  // namespace hanei
