#include "engine/project/gltf_lights.h"

#include "engine/project/gltf_punctual.h"
#include "engine/project/luminaire_file.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <map>
#include <numbers>
#include <utility>

namespace hanei {
namespace {

constexpr std::size_t most_lights = 1000;
constexpr std::size_t most_intensities = 20'000'000;

/// The axes of the file, y up, in those of the house, z up.
Vec3 upright(const Vec3& v) { return {v.x, -v.z, v.y}; }

/// A light as its extension defines it, for all nodes that show it.
struct Definition {
    bool is_directional = false;
    std::optional<Photometry> photometry;  ///< none: not sound, or directional
};

void warn_of_colour(Fields& fields, std::vector<std::string>& warnings) {
    Vec3 colour{1.0};
    if (fields.optional("color", colour) && colour != Vec3{1.0})
        warnings.push_back(fmt::format("the colour {:.3g} {:.3g} {:.3g} is left out", colour.x, colour.y, colour.z));
}

class Reading {
public:
    explicit Reading(GltfDocument& document) : reading_(document.reading()), document_(document) {}

    std::vector<GltfLight> read(const std::vector<GltfNode>& nodes) {
        for (const GltfNode& node : nodes) {
            const bool profiled = extension_of(node, "EXT_lights_ies") != nullptr;
            read_light(node, profiled ? "EXT_lights_ies" : "KHR_lights_punctual");
        }
        if (directional_ > 0)
            warn(fmt::format("{} of its lights are directional, without place or candela; they are left out",
                             directional_));
        if (too_many_) warn("the file holds more than 1000 lights or 20 million intensities; the rest is left out");
        return std::move(lights_);
    }

private:
    void warn(const std::string& message) { reading_.warn(document_.root(), "nodes", message); }

    const JsonValue* extension_of(const GltfNode& node, const std::string& extension) const {
        const JsonValue* const extensions = document_.root().find("nodes")->items[node.number].find("extensions");
        return extensions == nullptr ? nullptr : extensions->find(extension);
    }

    void read_light(const GltfNode& node, const std::string& extension) {
        const JsonValue& object = document_.root().find("nodes")->items[node.number];
        const JsonValue* const value = extension_of(node, extension);
        if (value == nullptr) return;
        const std::string node_path = "nodes[" + std::to_string(node.number) + ']';
        Fields shown(reading_, *value, node_path + ".extensions." + extension);
        const JsonValue* const index = shown.take("light");
        if (index == nullptr) return shown.missing("light", "the index of a light");
        const Definition* const light = definition(extension, *index, shown.path_of("light"));
        if (light == nullptr) return;
        directional_ += light->is_directional ? 1 : 0;
        if (!light->photometry) return;
        intensities_ += light->photometry->candela.size();
        too_many_ = too_many_ || lights_.size() >= most_lights || intensities_ > most_intensities;
        if (too_many_) return;
        GltfLight placed;
        placed.luminaire.photometry = *light->photometry;
        if (extension == "EXT_lights_ies" && !multiply(shown, placed.luminaire.photometry)) return;
        if (!place(node, node_path, object, placed)) return;
        name(object, node.number, placed.luminaire);
        lights_.push_back(std::move(placed));
    }

    /// Null, with an error, when there is no such light.
    const Definition* definition(const std::string& extension, const JsonValue& index, const std::string& path) {
        const JsonValue* const extensions = document_.root().find("extensions");
        const JsonValue* const object = extensions == nullptr ? nullptr : extensions->find(extension);
        const JsonValue* const list = object == nullptr ? nullptr : object->find("lights");
        const bool is_list = list != nullptr && list->is(JsonValue::Kind::list);
        const auto number = take_index(reading_, index, path, is_list ? list->items.size() : 0);
        if (!number) return nullptr;
        const auto [known, is_new] = definitions_.try_emplace({extension, *number});
        if (is_new) {
            Fields light(reading_, list->items[*number],
                         "extensions." + extension + ".lights[" + std::to_string(*number) + ']');
            known->second = extension == "EXT_lights_ies" ? profile(light) : punctual(light);
        }
        return &known->second;
    }

    Definition punctual(Fields& light) {
        const std::size_t before = reading_.findings.size();
        std::string type;
        double candela = 1.0;
        double range = 0.0;
        std::vector<std::string> warnings;
        light.require("type", type, "\"point\", \"spot\" or \"directional\"");
        light.optional("intensity", candela);
        if (type == "directional") return {true, std::nullopt};
        if (!(candela >= 0.0 && candela <= brightest))
            light.error("intensity", "found " + fmt::format("{}", candela) + ", expected 0 to 1e12 candela");
        warn_of_colour(light, warnings);
        if (light.optional("range", range)) warnings.push_back(fmt::format("its range of {:.4g} m is left out", range));
        Photometry photometry;
        if (type == "spot")
            photometry = spot(light, candela);
        else if (type == "point")
            photometry = point_light(candela);
        else if (!type.empty())
            light.error("type", "found " + json_quoted(type) + ", expected \"point\", \"spot\" or \"directional\"");
        photometry.warnings = std::move(warnings);
        return sound_since(before, std::move(photometry));
    }

    Photometry spot(Fields& light, double candela) {
        constexpr double quarter = std::numbers::pi / 2.0;
        constexpr double rounding = 1e-6;  // files hold angles in single precision
        double inner = 0.0;
        double outer = std::numbers::pi / 4.0;
        const JsonValue* const value = light.take("spot");
        if (value == nullptr) {
            light.missing("spot", "an object with the angles of the cone");
            return {};
        }
        Fields cone(reading_, *value, light.path_of("spot"));
        cone.optional("innerConeAngle", inner);
        cone.optional("outerConeAngle", outer);
        if (!(outer >= narrowest_cone && outer <= quarter + rounding)) {
            cone.error("outerConeAngle", fmt::format("found {}, expected 0.001 to 1.5708 radians", outer));
        } else if (!(inner >= 0.0 && inner <= outer)) {
            cone.error("innerConeAngle",
                       fmt::format("found {}, expected 0 to the outer angle of {} radians", inner, outer));
        } else {
            return spot_light(candela, inner, std::min(outer, quarter));
        }
        return {};
    }

    Definition profile(Fields& light) {
        const std::size_t before = reading_.findings.size();
        const JsonValue* const uri = light.take("uri");
        const JsonValue* const view = light.take("bufferView");
        std::string type;
        std::optional<std::string> own;
        std::optional<std::string_view> bytes;
        if (uri != nullptr && view != nullptr) {
            light.error("uri", "a bufferView stands beside it; one of them alone is allowed");
        } else if (uri != nullptr) {
            own = document_.uri_bytes(*uri, light.path_of("uri"));
            if (own) bytes = *own;
        } else if (view != nullptr) {
            if (!light.has("mimeType"))
                reading_.warn(light.value(), light.path_of("mimeType"),
                              "the field is missing beside a bufferView; the profile is read as it is");
            light.optional("mimeType", type);
            bytes = document_.view_bytes(*view, light.path_of("bufferView"));
        } else {
            light.missing("uri", "where the profile is");
        }
        if (!bytes) return {};
        LuminaireFileRead read = read_luminaire_text(*bytes, "profile");
        for (Diagnostic& finding : read.findings) {
            finding.message =
                fmt::format("its profile, line {}: {}: {}", finding.place.line, finding.place.field, finding.message);
            finding.place.file = reading_.file;
            finding.place.line = light.value().line;
            finding.place.field = light.path();
            reading_.findings.push_back(std::move(finding));
        }
        if (read.photometry) read.photometry->source_file.clear();
        return sound_since(before, read.photometry ? std::move(*read.photometry) : Photometry{});
    }

    Definition sound_since(std::size_t before, Photometry photometry) const {
        const auto first = reading_.findings.begin() + static_cast<std::ptrdiff_t>(before);
        const bool faulty = std::any_of(first, reading_.findings.end(),
                                        [](const Diagnostic& finding) { return finding.severity == Severity::error; });
        return faulty ? Definition{} : Definition{false, std::move(photometry)};
    }

    /// By the factor of a node; false, with an error, when it is none.
    bool multiply(Fields& shown, Photometry& photometry) {
        double factor = 1.0;
        if (shown.has("multiplier") && !shown.optional("multiplier", factor)) return false;
        const double peak = *std::max_element(photometry.candela.begin(), photometry.candela.end());
        if (!(factor >= 0.0 && peak * factor <= brightest)) {
            shown.error("multiplier",
                        fmt::format("found {}, expected 0 or more and no light above 1e12 candela", factor));
            return false;
        }
        warn_of_colour(shown, photometry.warnings);
        if (factor == 1.0) return true;
        for (double& candela : photometry.candela) candela *= factor;
        photometry.candela_per_figure *= factor;
        photometry.warnings.push_back(fmt::format("the scene multiplies its intensities by {}", factor));
        return true;
    }

    bool place(const GltfNode& node, const std::string& path, const JsonValue& object, GltfLight& placed) {
        const Vec3 x{node.to_world[0]};
        const Vec3 y{node.to_world[1]};
        const Vec3 z{node.to_world[2]};
        const double least = 1e-12 * std::max({glm::length(x), glm::length(y), glm::length(z)});
        const Vec3 down = upright(-z) / glm::length(z);
        const Vec3 across = upright(x) - glm::dot(upright(x), down) * down;
        if (!(glm::length(z) > least && glm::length(across) > least && std::isfinite(glm::length(across)))) {
            reading_.error(object, path, "its scale leaves the light no direction");
            return false;
        }
        placed.position = upright(Vec3{node.to_world[3]});
        placed.nadir = down;
        placed.plane_0 = across / glm::length(across);
        if (glm::dot(glm::cross(x, y), z) < 0.0 && placed.luminaire.photometry.horizontal_deg.size() > 1)
            placed.luminaire.photometry.warnings.emplace_back("its node is mirrored; the intensities are not");
        return true;
    }

    void name(const JsonValue& object, std::size_t number, NamedPhotometry& luminaire) {
        const JsonValue* const name = object.find("name");
        luminaire.name = name != nullptr && !name->text.empty() ? name->text : "node " + std::to_string(number);
        if (luminaire.photometry.name.empty()) luminaire.photometry.name = luminaire.name;
    }

    static constexpr double brightest = 1e12;  ///< cd: a thousand times the strongest searchlight

    JsonReading& reading_;
    GltfDocument& document_;
    std::vector<GltfLight> lights_;
    std::map<std::pair<std::string, std::size_t>, Definition> definitions_;
    std::size_t intensities_ = 0;
    int directional_ = 0;
    bool too_many_ = false;
};

}  // namespace

std::vector<GltfLight> placed_lights(GltfDocument& document, const std::vector<GltfNode>& nodes) {
    return Reading(document).read(nodes);
}

GltfRead read_gltf(std::string_view bytes, std::string_view name, const GltfNeighbour& neighbour) {
    GltfRead result;
    JsonReading reading{std::string{name}, {}};
    GltfDocument document{bytes, reading, neighbour};
    if (document.open()) {
        result.lights = placed_lights(document, placed_nodes(reading, document.root()));
        if (result.lights.empty() && !has_errors(reading.findings))
            reading.error(document.root(), "nodes",
                          "the scene shows no point, spot or profile light that could be a luminaire");
    }
    result.findings = std::move(reading.findings);
    return result;
}

}  // namespace hanei
