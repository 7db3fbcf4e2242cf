/// The URIs by which a glTF file names bytes: data of its own, or files beside it. Nothing else is asked.
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <string_view>

namespace hanei {

/// The bytes of a file in the folder of the one that names it, or nothing. The name is a neighbour_name.
using GltfNeighbour = std::function<std::optional<std::string>(const std::string& name)>;

/// What lies in the folder of `file` or below it: plain files of at most 256 MB. Links that lead out of
/// the folder are not followed.
GltfNeighbour gltf_neighbours(const std::filesystem::path& file);

/// The bytes of "data:TYPE;base64,..."; empty for any other text.
std::optional<std::string> data_uri_bytes(std::string_view uri);

/// The relative file name a URI stands for, its %20 and the like resolved; empty when it has a scheme
/// ("file:", "http:") or leads out of the folder.
std::optional<std::string> neighbour_name(std::string_view uri);

}  // namespace hanei
