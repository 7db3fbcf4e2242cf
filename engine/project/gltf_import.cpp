#include "engine/project/gltf_import.h"

#include "engine/project/gltf_lights.h"
#include "engine/project/gltf_objects.h"
#include "engine/project/gltf_scene.h"
#include "engine/project/gltf_units.h"

#include <cmath>
#include <fmt/format.h>
#include <fstream>
#include <system_error>

namespace hanei {
namespace {

constexpr double farthest = 1e6;  // m: farther, single precision leaves no furniture

GltfImport refused(const std::filesystem::path& file, std::string message) {
    GltfImport result;
    result.findings.push_back({Severity::error, {file.string(), 0, "file", 0}, std::move(message)});
    return result;
}

class Importing {
public:
    Importing(GltfDocument& document, const GltfImportOptions& wanted)
        : document_(document), options_(wanted), axes_{wanted.metres_per_unit, wanted.up == GltfUpAxis::z} {}

    /// Nothing with errors.
    void run(GltfImport& result) {
        check_required_extensions(document_);
        const bool as_written = options_.metres_per_unit == 1.0 && options_.up == GltfUpAxis::y;
        std::optional<Project> written = as_written ? own_project(document_) : std::nullopt;
        std::optional<Scene> own;
        if (written) own = std::move(written->scene);
        check_own_nodes(document_, own ? &*own : nullptr);
        if (has_errors(document_.reading().findings)) return;  // what follows from these would only mislead
        const auto nodes = placed_nodes(document_.reading(), document_.root(), own_scene(document_));
        const auto foreign = without_own_luminaires(nodes, own.has_value());
        const auto primitives = placed_primitives(document_, foreign, farthest / options_.metres_per_unit);
        std::vector<GltfLight> lights = hung(placed_lights(document_, foreign));
        if (own) place_own_luminaires(document_, nodes, *own);
        if (has_errors(document_.reading().findings)) return;
        GltfScene scene(document_, options_.kind, std::move(own));
        const bool look_into_root = options_.kind == GltfKind::room || !lights.empty();
        const auto label_of = [&](std::optional<std::size_t> material) { return scene.label_of(material); };
        const auto objects = gltf_objects(document_, nodes, primitives, axes_, label_of, look_into_root, options_.weld);
        scene.add(std::move(lights));
        scene.add(objects);
        check_size(primitives, result);
        if (!has_errors(document_.reading().findings)) scene.finish(result);
        if (written) result.settings = written->settings;
    }

private:
    std::vector<GltfNode> without_own_luminaires(std::vector<GltfNode> nodes, bool is_own) {
        if (is_own)
            std::erase_if(nodes,
                          [&](const GltfNode& node) { return own_node(document_, node.number).kind == "luminaire"; });
        return nodes;
    }

    /// From the axes of glTF, upright, to those the file was drawn in.
    std::vector<GltfLight> hung(std::vector<GltfLight> lights) {
        const auto as_drawn = [&](const Vec3& v) { return axes_.z_up ? Vec3{v.x, v.z, -v.y} : v; };
        for (GltfLight& light : lights) {
            light.position = options_.metres_per_unit * as_drawn(light.position);
            light.nadir = as_drawn(light.nadir);
            light.plane_0 = as_drawn(light.plane_0);
            if (!(glm::length(light.position) <= farthest))
                document_.reading().error(
                    document_.root(), "nodes",
                    fmt::format("the light \"{}\" hangs {:.3g} m from the origin, at most {:.0g} m are read",
                                light.luminaire.name, glm::length(light.position), farthest));
        }
        return lights;
    }

    void check_size(const std::vector<GltfPrimitive>& primitives, GltfImport& result) {
        bool any = false;
        Vec3 low{0.0}, high{0.0};
        for (const GltfPrimitive& primitive : primitives)
            for (const Vec3& vertex : primitive.vertices) {
                const Vec3 place = axes_.place(vertex);
                low = any ? glm::min(low, place) : place;
                high = any ? glm::max(high, place) : place;
                any = true;
            }
        result.size = high - low;
        if (const std::string doubt = any ? doubtful_size(result.size, options_.metres_per_unit) : ""; !doubt.empty())
            document_.reading().warn(document_.root(), "meshes", doubt);
    }

    GltfDocument& document_;
    GltfImportOptions options_;
    GltfAxes axes_;
};

}  // namespace

GltfImport import_gltf(std::string_view bytes, std::string_view name, const GltfNeighbour& neighbour,
                       const GltfImportOptions& wanted) {
    GltfImport result;
    JsonReading reading{std::string{name}, {}};
    GltfDocument document{bytes, reading, neighbour};
    if (document.open()) Importing(document, wanted).run(result);
    result.findings = std::move(reading.findings);
    if (has_errors(result.findings)) {
        result.scene.reset();
        result.settings.reset();
    }
    return result;
}

GltfImport import_gltf(const std::filesystem::path& file, const GltfImportOptions& wanted) {
    constexpr std::uintmax_t most = 256U << 20U;
    std::error_code error;
    const std::uintmax_t size = std::filesystem::file_size(file, error);  // of a plain file: a pipe would wait
    if (error) return refused(file, "cannot be read: " + error.message());
    if (size > most) return refused(file, fmt::format("{} bytes; {} can be read at most", size, most));
    std::ifstream stream{file, std::ios::binary};
    std::string bytes(static_cast<std::size_t>(size), '\0');
    stream.read(bytes.data(), static_cast<std::streamsize>(bytes.size()));
    if (!stream) return refused(file, "cannot be read");
    return import_gltf(bytes, file.string(), gltf_neighbours(file), wanted);
}

}  // namespace hanei
