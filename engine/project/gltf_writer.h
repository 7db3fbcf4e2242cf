/// A glTF 2.0 file on its way out: its JSON and its one buffer.
#pragma once

#include "engine/base/vector.h"
#include "engine/project/json_value.h"

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace hanei {

/// Numbers returned are indices into the list of the file that an item was added to.
///
/// Holds     everything until the end; at most 4 GB of bytes, as binary files can.
class GltfWriter {
public:
    explicit GltfWriter(std::string_view generator);

    /// Single precision, with the bounds that places must have.
    int add_places(std::span<const Vec3> places);
    /// Linear red, green and blue, 0 to 1, in 16 bits each; opaque.
    int add_colours(std::span<const std::array<float, 3>> colours);
    int add_indices(std::span<const std::uint32_t> indices);

    /// Bytes that are no figures; the number of their buffer view.
    int add_bytes(std::string_view bytes);

    /// Appends to a list at the root ("nodes").
    int add(const std::string& list, JsonValue item);
    JsonValue& root() { return root_; }
    void use_extension(const std::string& name);

    std::string text();    ///< .gltf, its buffer as a data URI
    std::string binary();  ///< .glb

private:
    JsonValue& list(const std::string& name);
    JsonValue view_of(std::string_view bytes);
    int add_accessor(const std::string& bytes, int component, std::size_t count, const char* type, int target,
                     JsonValue bounds);
    JsonValue finished(bool with_uri);

    JsonValue root_;
    std::string bytes_;
};

std::string base64(std::string_view bytes);

}  // namespace hanei
