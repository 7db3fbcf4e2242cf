#include "engine/project/gltf_meshes.h"

#include "engine/project/gltf_accessor.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <map>
#include <string_view>
#include <utility>

namespace hanei {
namespace {

/// A primitive in its mesh's own frame, read once for all nodes that show the mesh.
struct RawPrimitive {
    std::optional<std::size_t> material;
    std::vector<Vec3> vertices;
    std::vector<std::array<std::uint32_t, 3>> triangles;
};

std::vector<std::array<std::uint32_t, 3>> triangles_of(const std::vector<std::uint32_t>& corners, int mode) {
    std::vector<std::array<std::uint32_t, 3>> triangles;
    if (mode == 4)
        for (std::size_t k = 2; k < corners.size(); k += 3)
            triangles.push_back({corners[k - 2], corners[k - 1], corners[k]});
    if (mode == 5)  // every other triangle of a strip runs the other way
        for (std::size_t k = 2; k < corners.size(); ++k)
            triangles.push_back({corners[k - 2], corners[k - 1 + k % 2], corners[k - k % 2]});
    if (mode == 6)
        for (std::size_t k = 2; k < corners.size(); ++k) triangles.push_back({corners[k - 1], corners[k], corners[0]});
    return triangles;
}

class MeshReading {
public:
    MeshReading(GltfDocument& document, double farthest) : document_(document), farthest_(farthest) {}

    std::vector<GltfPrimitive> read(const std::vector<GltfNode>& nodes) {
        for (const GltfNode& node : nodes)
            if (!read_node(node)) break;
        tell(lines_, "of its primitives consist of points or lines; they are left out");
        tell(skins_, "of its nodes are bent by a skin; they are taken as they stand at rest");
        tell(morphs_, "of its primitives have other forms to change into; they are taken in their first");
        tell(coloured_, "of its primitives have colours at their vertices; the material's colour is taken");
        return std::move(placed_);
    }

private:
    bool read_node(const GltfNode& node) {
        const std::string path = "nodes[" + std::to_string(node.number) + ']';
        Fields fields(document_.reading(), document_.root().find("nodes")->items[node.number], path);
        const JsonValue* const index = fields.take("mesh");
        if (index == nullptr) return true;
        const JsonValue* const mesh = document_.item(*index, path + ".mesh", "meshes");
        if (mesh == nullptr) return true;
        skins_ += fields.has("skin") ? 1 : 0;
        for (const RawPrimitive& raw : primitives_of(*mesh, static_cast<std::size_t>(index->number))) {
            triangles_ += raw.triangles.size();
            vertices_ += raw.vertices.size();
            if (triangles_ > most_gltf_triangles || vertices_ > 3 * most_gltf_triangles) {
                document_.reading().error(
                    *mesh, path + ".mesh",
                    fmt::format("with this node the scene has more than the {} triangles that are read; simplify it",
                                most_gltf_triangles));
                return false;
            }
            if (!place(node, raw, path)) return true;
        }
        return true;
    }

    bool place(const GltfNode& node, const RawPrimitive& raw, const std::string& path) {
        GltfPrimitive primitive{node.number, raw.material, {}, raw.triangles};
        primitive.vertices.reserve(raw.vertices.size());
        for (const Vec3& vertex : raw.vertices) {
            const Vec3 there{node.to_world * glm::dvec4{vertex, 1.0}};
            const double away = std::max({std::abs(there.x), std::abs(there.y), std::abs(there.z)});
            if (!(away <= farthest_)) {
                document_.reading().error(
                    document_.root().find("nodes")->items[node.number], path,
                    fmt::format("a vertex lies {:.3g} units from the origin, at most {:.3g} are read", away,
                                farthest_));
                return false;
            }
            primitive.vertices.push_back(there);
        }
        const auto column = [&](int k) { return Vec3{node.to_world[k]}; };
        if (glm::dot(glm::cross(column(0), column(1)), column(2)) < 0.0)
            for (auto& triangle : primitive.triangles) std::swap(triangle[1], triangle[2]);
        placed_.push_back(std::move(primitive));
        return true;
    }

    const std::vector<RawPrimitive>& primitives_of(const JsonValue& mesh, std::size_t number) {
        const auto [known, is_new] = meshes_.try_emplace(number);
        if (!is_new) return known->second;
        const std::string path = "meshes[" + std::to_string(number) + ']';
        const JsonValue* const list = mesh.find("primitives");
        if (list == nullptr) {
            document_.reading().error(mesh, path, "it has no primitives");
            return known->second;
        }
        if (!take_list(document_.reading(), *list, path + ".primitives")) return known->second;
        for (std::size_t k = 0; k < list->items.size(); ++k) {
            Fields fields(document_.reading(), list->items[k], path + ".primitives[" + std::to_string(k) + ']');
            if (auto raw = primitive(fields)) known->second.push_back(std::move(*raw));
        }
        return known->second;
    }

    std::optional<RawPrimitive> primitive(Fields& fields) {
        int mode = 4;
        fields.optional("mode", mode);
        if (mode < 0 || mode > 6) {
            fields.error("mode", fmt::format("found {}, expected 0 to 6", mode));
            return std::nullopt;
        }
        if (mode < 4) {
            ++lines_;
            return std::nullopt;
        }
        const JsonValue* const attributes = fields.take("attributes");
        const JsonValue* const place = attributes == nullptr ? nullptr : attributes->find("POSITION");
        if (place == nullptr) {
            fields.missing("attributes.POSITION", "the index of an accessor");
            return std::nullopt;
        }
        RawPrimitive raw;
        if (!take_material(fields, raw)) return std::nullopt;
        auto vertices = read_places(document_, *place, fields.path_of("attributes.POSITION"));
        if (!vertices) return std::nullopt;
        raw.vertices = std::move(*vertices);
        read_ += raw.vertices.size();
        if (read_ > most_read) {
            fields.error("attributes", fmt::format("with these the meshes have more than the {} vertices that are "
                                                   "read; simplify them",
                                                   most_read));
            return std::nullopt;
        }
        coloured_ += attributes->find("COLOR_0") != nullptr ? 1 : 0;
        morphs_ += fields.has("targets") ? 1 : 0;
        std::vector<std::uint32_t> corners;
        if (const JsonValue* const index = fields.take("indices")) {
            auto numbers = read_indices(document_, *index, fields.path_of("indices"), raw.vertices.size());
            if (!numbers) return std::nullopt;
            corners = std::move(*numbers);
        } else {
            for (std::size_t k = 0; k < raw.vertices.size(); ++k) corners.push_back(static_cast<std::uint32_t>(k));
        }
        if (mode == 4 && corners.size() % 3 != 0) {
            document_.reading().error(fields.value(), fields.path(),
                                      fmt::format("{} corners are no whole number of triangles", corners.size()));
            return std::nullopt;
        }
        raw.triangles = triangles_of(corners, mode);
        return raw;
    }

    bool take_material(Fields& fields, RawPrimitive& raw) {
        const JsonValue* const index = fields.take("material");
        if (index == nullptr) return true;
        if (document_.item(*index, fields.path_of("material"), "materials") == nullptr) return false;
        raw.material = static_cast<std::size_t>(index->number);
        return true;
    }

    void tell(int count, const char* what) {
        if (count > 0) document_.reading().warn(document_.root(), "meshes", fmt::format("{} {}", count, what));
    }

    static constexpr std::size_t most_read = 3 * most_gltf_triangles;

    GltfDocument& document_;
    double farthest_;
    std::size_t read_ = 0;  ///< vertices of all meshes
    std::map<std::size_t, std::vector<RawPrimitive>> meshes_;
    std::vector<GltfPrimitive> placed_;
    std::size_t triangles_ = 0, vertices_ = 0;
    int lines_ = 0, skins_ = 0, morphs_ = 0, coloured_ = 0;
};

/// Extensions that change how things look, or that are read.
bool is_understood(std::string_view extension) {
    constexpr std::string_view read[] = {"KHR_lights_punctual", "EXT_lights_ies", "KHR_mesh_quantization",
                                         "KHR_texture_transform"};
    return extension.starts_with("KHR_materials_") || extension.find("texture") != std::string_view::npos ||
           std::find(std::begin(read), std::end(read), extension) != std::end(read);
}

}  // namespace

std::vector<GltfPrimitive> placed_primitives(GltfDocument& document, const std::vector<GltfNode>& nodes,
                                             double farthest) {
    return MeshReading(document, farthest).read(nodes);
}

void check_required_extensions(GltfDocument& document) {
    const JsonValue* const list = document.root().find("extensionsRequired");
    if (list == nullptr || !take_list(document.reading(), *list, "extensionsRequired")) return;
    for (std::size_t k = 0; k < list->items.size(); ++k) {
        const std::string path = "extensionsRequired[" + std::to_string(k) + ']';
        std::string name;
        if (!take_value(document.reading(), list->items[k], path, name) || is_understood(name)) continue;
        document.reading().error(
            list->items[k], path,
            "found " + described(list->items[k]) + ", which is not read; export the file without it (uncompressed)");
    }
}

}  // namespace hanei
