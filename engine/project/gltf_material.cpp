#include "engine/project/gltf_material.h"

#include "engine/project/project_reader.h"
#include "engine/scene/colour.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <numbers>

namespace hanei {
namespace {

class MaterialReading {
public:
    MaterialReading(JsonReading& reading, const JsonValue& value, std::size_t number)
        : reading_(reading), fields_(reading, value, "materials[" + std::to_string(number) + ']') {
        result_.material.name = "material " + std::to_string(number + 1);
    }

    GltfMaterial read() {
        std::string name;
        fields_.optional("name", name);
        if (!name.empty()) result_.material.name = name;
        fields_.optional("doubleSided", result_.two_sided);
        read_colour();
        read_emission();
        read_transparency();
        take_exact_figures();
        return std::move(result_);
    }

private:
    const JsonValue* extension(std::string_view name) {
        const JsonValue* const extensions = fields_.take("extensions");
        return extensions == nullptr ? nullptr : extensions->find(name);
    }

    void warn(const std::string& key, const std::string& message) {
        reading_.warn(fields_.value(), fields_.path_of(key), '"' + result_.material.name + "\": " + message);
    }

    /// Three shares from 0 to 1, of a list that may have a fourth.
    bool take_shares(Fields& fields, std::string_view key, std::size_t count, Vec3& shares) {
        std::vector<double> figures;
        if (!fields.has(key) || !fields.optional(key, figures)) return false;
        const bool sound = figures.size() == count && std::all_of(figures.begin(), figures.end(), [](double figure) {
                               return figure >= 0.0 && figure <= 1.0;
                           });
        if (!sound) {
            fields.error(key, fmt::format("expected {} figures from 0 to 1", count));
            return false;
        }
        shares = {figures[0], figures[1], figures[2]};
        if (count == 4) alpha_ = figures[3];
        return true;
    }

    void read_colour() {
        Vec3 colour{1.0};
        bool image = false;
        if (const JsonValue* const value = fields_.take("pbrMetallicRoughness")) {
            Fields pbr(reading_, *value, fields_.path_of("pbrMetallicRoughness"));
            take_shares(pbr, "baseColorFactor", 4, colour);
            image = pbr.has("baseColorTexture");
            double metal = 0.0;
            pbr.optional("metallicFactor", metal);
            if (!(metal >= 0.0 && metal <= 1.0))
                pbr.error("metallicFactor", fmt::format("found {}, expected 0 to 1", metal));
            if (metal > 0.5)
                warn("pbrMetallicRoughness", "it is metal; what it mirrors is taken as reflected diffusely");
        } else if (const JsonValue* const older = extension("KHR_materials_pbrSpecularGlossiness")) {
            Fields diffuse(reading_, *older, fields_.path_of("extensions.KHR_materials_pbrSpecularGlossiness"));
            take_shares(diffuse, "diffuseFactor", 4, colour);
            image = diffuse.has("diffuseTexture");
        }
        factor_ = colour;
        if (image) {
            constexpr double middle_grey = 0.5;
            colour *= middle_grey;
            warn("pbrMetallicRoughness.baseColorTexture",
                 fmt::format("its colour is an image, which is not looked at; reflectance {:.2g} stands for it, "
                             "set the right one",
                             luminance(colour)));
        }
        const double greatest = std::max({colour.x, colour.y, colour.z});
        if (greatest > most_of_a_chosen_band) colour *= most_of_a_chosen_band / greatest;
        set_colour(colour);
        darkened_ = greatest > most_of_a_chosen_band;
    }

    void set_colour(const Vec3& colour) {
        const bool grey = colour.x == colour.y && colour.y == colour.z;
        result_.material.reflectance = grey ? colour.x : luminance(colour);
        result_.material.tint = grey ? Vec3{1.0} : colour / luminance(colour);
    }

    void read_emission() {
        Vec3 colour{0.0};
        double strength = 1.0;
        const bool shines = take_shares(fields_, "emissiveFactor", 3, colour) && colour != Vec3{0.0};
        const JsonValue* const value = extension("KHR_materials_emissive_strength");
        if (value != nullptr) {
            Fields fields(reading_, *value, fields_.path_of("extensions.KHR_materials_emissive_strength"));
            fields.optional("emissiveStrength", strength);
            constexpr double brightest = 1e9;  // cd/m2: little less than the sun's disc
            if (!(strength >= 0.0 && strength <= brightest))
                return fields.error("emissiveStrength", fmt::format("found {}, expected 0 to 1e9 cd/m2", strength));
        }
        if (!shines) return;
        if (value == nullptr)
            return warn("emissiveFactor",
                        "it shines, but without KHR_materials_emissive_strength in no unit; that is left out");
        result_.own_exitance.value = std::numbers::pi * strength * luminance(colour);
        const bool neutral = colour.x == colour.y && colour.y == colour.z;
        if (!neutral) warn("emissiveFactor", "the colour it shines in is left out");
    }

    void read_transparency() {
        std::string mode = "OPAQUE";
        fields_.optional("alphaMode", mode);
        const bool clear = extension("KHR_materials_transmission") != nullptr;
        if (clear || (mode != "OPAQUE" && alpha_ < 1.0))
            warn(clear ? "extensions" : "alphaMode", "light goes through it in the file; here it is opaque");
    }

    /// "extras": {"hanei": {"reflectance": 0.5, "tint": [1, 1, 1]}}, unless somebody has changed the colour.
    void take_exact_figures() {
        const JsonValue* const extras = fields_.take("extras");
        const JsonValue* const own = extras == nullptr ? nullptr : extras->find("hanei");
        if (own != nullptr && own->is(JsonValue::Kind::object)) {
            Fields fields(reading_, *own, fields_.path_of("extras.hanei"));
            if (const JsonValue* const id = fields.take("id")) {
                if (is_id(*id))
                    result_.material.id.value = static_cast<std::uint32_t>(id->number);
                else
                    fields.error("id", "found " + described(*id) + ", expected a whole number from 1 to 4294967294");
            }
            Material exact = result_.material;
            exact.tint = Vec3{1.0};
            fields.optional("reflectance", exact.reflectance);
            fields.optional("tint", exact.tint);
            const Vec3 away = glm::abs(exact.reflectance * exact.tint - factor_);
            constexpr double rounding = 1e-6;
            if (std::max({away.x, away.y, away.z}) <= rounding &&
                std::abs(luminance(exact.tint) - 1.0) <= tint_tolerance && exact.reflectance >= 0.0 &&
                exact.reflectance <= 1.0 && glm::all(glm::greaterThanEqual(exact.tint, Vec3(0.0)))) {
                const double greatest = std::max({exact.tint.x, exact.tint.y, exact.tint.z});
                if (exact.reflectance * greatest <= 1.0) {
                    result_.material = exact;
                    darkened_ = false;
                }
            }
        }
        if (darkened_)
            warn("pbrMetallicRoughness.baseColorFactor",
                 fmt::format("no paint reflects that much; its reflectance is taken as {:.2g}",
                             result_.material.reflectance));
    }

    JsonReading& reading_;
    Fields fields_;
    GltfMaterial result_;
    Vec3 factor_{1.0};
    double alpha_ = 1.0;
    bool darkened_ = false;
};

}  // namespace

GltfMaterial read_gltf_material(GltfDocument& document, std::size_t number) {
    const JsonValue& value = document.root().find("materials")->items[number];
    return MaterialReading(document.reading(), value, number).read();
}

GltfMaterial unstated_gltf_material() {
    GltfMaterial grey;
    grey.material.name = "not stated";
    grey.two_sided = true;
    return grey;
}

}  // namespace hanei
