/// A glTF 2.0 file in memory, as text (.gltf) or binary (.glb): its JSON, and the bytes its buffers hold.
#pragma once

#include "engine/project/gltf_uri.h"
#include "engine/project/json_fields.h"

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <string_view>

namespace hanei {

/// Nothing is read before it is asked for: the geometry of a building may be missing or huge.
///
/// Holds     a view of the bytes and a reference to what collects the findings; both must outlive it.
class GltfDocument {
public:
    /// Without a glTF 2 there is an error, and nothing is held.
    GltfDocument(std::string_view bytes, JsonReading& reading, GltfNeighbour neighbour);

    bool open() const { return root_.has_value(); }
    const JsonValue& root() const { return *root_; }
    JsonReading& reading() { return reading_; }

    /// An item of a list at the root, by an index that a file gives.
    /// Returns   null, with an error at `path`, for anything but a whole number that counts one of them.
    const JsonValue* item(const JsonValue& index, const std::string& path, std::string_view list);

    /// The bytes of bufferViews[index]; empty, with an error, when they do not lie within their buffer.
    std::optional<std::string_view> view_bytes(const JsonValue& index, const std::string& path);

    /// What a data URI holds or a file beside this one; empty, with an error at `path`, for anything else.
    std::optional<std::string> uri_bytes(const JsonValue& uri, const std::string& path);

private:
    std::optional<std::string_view> json_chunk(std::string_view bytes);
    std::optional<std::string_view> buffer_bytes(const JsonValue& buffer, std::size_t number);

    JsonReading& reading_;
    GltfNeighbour neighbour_;
    std::optional<JsonValue> root_;
    std::optional<std::string_view> binary_chunk_;
    std::map<std::size_t, std::optional<std::string>> buffers_;  ///< read so far
};

/// The index that `value` gives into a list of `count`; empty, with an error, when it is none.
std::optional<std::size_t> take_index(JsonReading& reading, const JsonValue& value, const std::string& path,
                                      std::size_t count);

/// By its first bytes: those of a binary file, or of JSON, which no other luminaire file is.
bool looks_like_gltf(std::string_view bytes);

}  // namespace hanei
