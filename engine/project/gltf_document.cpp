#include "engine/project/gltf_document.h"

#include "engine/project/luminaire_text.h"

#include <cmath>
#include <cstdint>
#include <fmt/format.h>
#include <utility>

namespace hanei {
namespace {

constexpr std::string_view binary_magic = "glTF";
constexpr std::size_t most_json = 64U << 20U;

std::uint32_t number_at(std::string_view bytes, std::size_t place) {
    std::uint32_t number = 0;
    for (std::size_t k = 4; k > 0; --k) number = number << 8U | static_cast<unsigned char>(bytes[place + k - 1]);
    return number;
}

/// A count of bytes; empty, with an error, for anything but a whole number. Larger ones than any file
/// has are kept: they are told apart from what is there.
std::optional<double> take_bytes(JsonReading& reading, const JsonValue* value, const std::string& path) {
    double count = 0.0;
    if (value == nullptr) return count;
    if (!take_value(reading, *value, path, count)) return std::nullopt;
    if (count >= 0.0 && count == std::floor(count)) return count;
    reading.error(*value, path, "found " + described(*value) + ", expected a whole number of bytes from 0");
    return std::nullopt;
}

const JsonValue* list_of(const JsonValue& root, std::string_view name) {
    const JsonValue* const list = root.find(name);
    return list != nullptr && list->is(JsonValue::Kind::list) ? list : nullptr;
}

bool is_version_2(JsonReading& reading, const JsonValue& root) {
    const JsonValue* const asset = root.find("asset");
    const JsonValue* const version = asset == nullptr ? nullptr : asset->find("version");
    if (version != nullptr && version->is(JsonValue::Kind::text) && version->text.starts_with("2.")) return true;
    const JsonValue& at = version == nullptr ? root : *version;
    const std::string found = version == nullptr ? "nothing" : described(*version);
    reading.error(at, "asset.version", "found " + found + ", expected \"2.0\": files of glTF 2 are read");
    return false;
}

}  // namespace

GltfDocument::GltfDocument(std::string_view bytes, JsonReading& reading, GltfNeighbour neighbour)
    : reading_(reading), neighbour_(std::move(neighbour)) {
    const std::optional<std::string_view> json = json_chunk(bytes);
    if (!json) return;
    root_ = parse_json(*json, reading.file, reading.findings);
    if (root_ && (has_errors(reading.findings) || !is_version_2(reading, *root_))) root_.reset();
}

/// Text is its own chunk. A binary file has a header of 12 bytes, then chunks of 8 bytes and their data.
std::optional<std::string_view> GltfDocument::json_chunk(std::string_view bytes) {
    const auto refused = [&](const std::string& field, const std::string& message) {
        reading_.error({}, field, message);
        return std::nullopt;
    };
    if (!bytes.starts_with(binary_magic)) {
        if (bytes.starts_with("\xEF\xBB\xBF")) bytes.remove_prefix(3);
        if (bytes.size() > most_json) return refused("file", "the text is longer than the 64 MB that are read");
        return bytes;
    }
    constexpr std::size_t header = 12;
    constexpr std::size_t chunk_header = 8;
    if (bytes.size() < header) return refused("header", "the file ends within its header of 12 bytes");
    if (number_at(bytes, 4) != 2)
        return refused("header", fmt::format("version {} found, expected 2", number_at(bytes, 4)));
    std::optional<std::string_view> json;
    std::size_t place = header;
    for (int chunk = 0; chunk < 2 && place < bytes.size(); ++chunk) {
        const std::string field = "chunk " + std::to_string(chunk);
        if (bytes.size() - place < chunk_header)
            return refused(field, fmt::format("at byte {}: the file ends within the chunk's header", place));
        const std::size_t length = number_at(bytes, place);
        const std::string_view kind = bytes.substr(place + 4, 4);
        if (length > bytes.size() - place - chunk_header)
            return refused(field, fmt::format("at byte {}: the chunk has {} bytes by its header, {} are left", place,
                                              length, bytes.size() - place - chunk_header));
        const std::string_view data = bytes.substr(place + chunk_header, length);
        if (chunk == 0 && kind == "JSON") json = data;
        if (chunk == 1 && kind == std::string_view{"BIN\0", 4}) binary_chunk_ = data;
        place += chunk_header + length;
    }
    if (!json) return refused("chunk 0", "at byte 12: the first chunk is not the JSON that it must be");
    if (json->size() > most_json) return refused("chunk 0", "the JSON is longer than the 64 MB that are read");
    return json;
}

const JsonValue* GltfDocument::item(const JsonValue& index, const std::string& path, std::string_view list) {
    const JsonValue* const items = list_of(*root_, list);
    const auto number = take_index(reading_, index, path, items == nullptr ? 0 : items->items.size());
    return number ? &items->items[*number] : nullptr;
}

std::optional<std::string_view> GltfDocument::view_bytes(const JsonValue& index, const std::string& path) {
    const JsonValue* const view = item(index, path, "bufferViews");
    if (view == nullptr) return std::nullopt;
    const std::string view_path = "bufferViews[" + described(index) + ']';
    Fields fields(reading_, *view, view_path);
    const JsonValue* const buffer_index = fields.take("buffer");
    if (buffer_index == nullptr) {
        fields.missing("buffer", "the index of a buffer");
        return std::nullopt;
    }
    const JsonValue* const buffer = item(*buffer_index, fields.path_of("buffer"), "buffers");
    const auto offset = take_bytes(reading_, fields.take("byteOffset"), fields.path_of("byteOffset"));
    const auto length = take_bytes(reading_, fields.take("byteLength"), fields.path_of("byteLength"));
    if (buffer == nullptr || !offset || !length) return std::nullopt;
    const auto bytes = buffer_bytes(*buffer, static_cast<std::size_t>(buffer_index->number));
    if (!bytes) return std::nullopt;
    const auto size = static_cast<double>(bytes->size());
    if (*offset > size || *length > size - *offset) {
        reading_.error(*view, view_path,
                       fmt::format("{:.0f} bytes from byte {:.0f} on lie past the end of the buffer, which has {}",
                                   *length, *offset, bytes->size()));
        return std::nullopt;
    }
    return bytes->substr(static_cast<std::size_t>(*offset), static_cast<std::size_t>(*length));
}

std::optional<std::string_view> GltfDocument::buffer_bytes(const JsonValue& buffer, std::size_t number) {
    const std::string path = "buffers[" + std::to_string(number) + ']';
    const JsonValue* const uri = buffer.find("uri");
    if (uri == nullptr) {
        if (number == 0 && binary_chunk_) return binary_chunk_;
        reading_.error(buffer, path, "it has no uri, and the file no binary chunk for it");
        return std::nullopt;
    }
    const auto [place, is_new] = buffers_.try_emplace(number);
    if (is_new) place->second = uri_bytes(*uri, path + ".uri");
    if (!place->second) return std::nullopt;
    return std::string_view{*place->second};
}

std::optional<std::string> GltfDocument::uri_bytes(const JsonValue& uri, const std::string& path) {
    std::string text;
    if (!take_value(reading_, uri, path, text)) return std::nullopt;
    const auto refused = [&](const std::string& message) {
        reading_.error(uri, path, "found " + described(uri) + message);
        return std::nullopt;
    };
    if (text.starts_with("data:")) {
        std::optional<std::string> bytes = data_uri_bytes(text);
        if (!bytes) return refused(", which is no base64 data");
        return bytes;
    }
    const std::optional<std::string> name = neighbour_name(text);
    if (!name) return refused("; only files in the folder of this one and below it are read");
    std::optional<std::string> bytes = neighbour_ ? neighbour_(*name) : std::nullopt;
    if (!bytes) return refused("; there is no such file beside this one, or it cannot be read");
    return bytes;
}

std::optional<std::size_t> take_index(JsonReading& reading, const JsonValue& value, const std::string& path,
                                      std::size_t count) {
    int index = 0;
    if (!take_value(reading, value, path, index)) return std::nullopt;
    if (index >= 0 && static_cast<std::size_t>(index) < count) return static_cast<std::size_t>(index);
    reading.error(
        value, path,
        "found " + described(value) +
            (count == 0
                 ? std::string{", but the list it counts in is empty"}
                 : ", expected " + (count == 1 ? "0 alone" : "a whole number from 0 to " + std::to_string(count - 1))));
    return std::nullopt;
}

bool looks_like_gltf(std::string_view bytes) {
    if (bytes.starts_with(binary_magic)) return true;
    if (bytes.starts_with("\xEF\xBB\xBF")) bytes.remove_prefix(3);
    return trimmed(bytes).starts_with('{');
}

}  // namespace hanei
