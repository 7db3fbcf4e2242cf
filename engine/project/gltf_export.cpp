#include "engine/project/gltf_export.h"

#include "engine/project/gltf_export_light.h"
#include "engine/project/gltf_pieces.h"
#include "engine/project/gltf_writer.h"
#include "engine/project/ies_profile.h"
#include "engine/project/project_writer.h"
#include "engine/project/text_file.h"
#include "engine/scene/colour.h"
#include "engine/scene/placement.h"

#include <glm/gtc/quaternion.hpp>

#include <cmath>
#include <map>
#include <numbers>
#include <utility>

namespace hanei {
namespace {

/// From the house's axes, z up, to those of glTF, y up.
Vec3 lying(const Vec3& v) { return {v.x, v.z, -v.y}; }

JsonValue json_numbers(std::initializer_list<double> numbers) {
    JsonValue list = json_list();
    for (const double number : numbers) list.items.push_back(json_number(number));
    return list;
}

JsonValue own_extras(JsonValue own) {
    JsonValue extras = json_object();
    extras.add("hanei", std::move(own));
    return extras;
}

JsonValue own_kind(const char* kind, ObjectId id) {
    JsonValue own = json_object();
    own.add("kind", json_text(kind));
    own.add("id", json_number(id.value));
    return own;
}

class Export {
public:
    explicit Export(const Project& project) : project_(project), scene_(project.scene), writer_("Hanei") {}

    std::string file(const LitPicture* picture, bool binary) {
        add_room();
        for (const Furniture& furniture : scene_.furniture) add_furniture(furniture);
        for (const FreeSurface& surface : scene_.surfaces) add_surface(surface);
        const std::size_t objects = plain_.size();
        for (const Luminaire& luminaire : scene_.luminaires) add_luminaire(luminaire);
        if (picture != nullptr) {
            std::vector<int> lit;
            for (const LitSurface& surface : picture->surfaces) lit.push_back(add_lit(surface));
            lit.insert(lit.end(), plain_.begin() + static_cast<std::ptrdiff_t>(objects), plain_.end());
            add_scene("light", lit, picture);
        }
        add_scene(scene_.title.empty() ? "scene" : scene_.title, plain_, nullptr);
        if (!lights_.items.empty()) add_light_lists();
        JsonValue own = json_object();
        own.add("scene", json_number(picture == nullptr ? 0 : 1));
        own.add("project", json_of(project_));
        writer_.root().add("scene", json_number(0));
        writer_.root().add("extras", own_extras(std::move(own)));
        return binary ? writer_.binary() : writer_.text();
    }

private:
    void add_scene(const std::string& name, const std::vector<int>& nodes, const LitPicture* picture) {
        JsonValue made = json_object();
        made.add("name", json_text(name));
        if (!nodes.empty()) made.add("nodes", json_of(nodes));
        if (picture != nullptr) {
            JsonValue own = json_object();
            own.add("colours", json_text(picture->colours));
            if (picture->high > picture->low) own.add("lux", json_numbers({picture->low, picture->high}));
            made.add("extras", own_extras(std::move(own)));
        }
        writer_.add("scenes", std::move(made));
    }

    void add_light_lists() {
        writer_.use_extension("KHR_lights_punctual");
        writer_.use_extension("EXT_lights_ies");
        JsonValue& extensions = writer_.root().add("extensions", json_object());
        extensions.add("KHR_lights_punctual", json_object()).add("lights", lights_);
        extensions.add("EXT_lights_ies", json_object()).add("lights", profiles_);
    }

    /// The number of the luminaire's light in EXT_lights_ies; one for all that shine alike.
    int profile(const Luminaire& luminaire) {
        const std::string text = ies_profile(scene_, luminaire);
        const auto [known, is_new] = profile_of_.try_emplace(text, static_cast<int>(profiles_.items.size()));
        if (!is_new) return known->second;
        JsonValue made = json_object();
        if (!luminaire.name.empty()) made.add("name", json_text(luminaire.name));
        made.add("bufferView", json_number(writer_.add_bytes(text)));
        made.add("mimeType", json_text("application/x-ies-lm-63"));
        profiles_.items.push_back(std::move(made));
        return known->second;
    }

    /// One a material and an emission.
    int material(ObjectId id, LuminousExitance exitance) {
        const auto [known, is_new] = materials_.try_emplace({id, exitance.value}, 0);
        if (!is_new) return known->second;
        const Material* const found = find_material(scene_, id);
        const Material stated = found == nullptr ? Material{} : *found;
        JsonValue made = json_object();
        made.add("name", json_text(stated.name));
        const auto [red, green, blue] = band_reflectances(stated);
        JsonValue& pbr = made.add("pbrMetallicRoughness", json_object());
        pbr.add("baseColorFactor", json_numbers({red, green, blue, 1.0}));
        pbr.add("metallicFactor", json_number(0.0));
        pbr.add("roughnessFactor", json_number(1.0));
        if (exitance.value > 0.0) add_emission(made, exitance.value / std::numbers::pi);
        JsonValue own = json_object();
        if (found != nullptr) own.add("id", json_number(id.value));
        own.add("reflectance", json_number(stated.reflectance));
        own.add("tint", json_of(stated.tint));
        made.add("extras", own_extras(std::move(own)));
        return known->second = writer_.add("materials", std::move(made));
    }

    void add_emission(JsonValue& made, double luminance) {
        made.add("emissiveFactor", json_numbers({1.0, 1.0, 1.0}));
        made.add("extensions", json_object())
            .add("KHR_materials_emissive_strength", json_object())
            .add("emissiveStrength", json_number(luminance));
        writer_.use_extension("KHR_materials_emissive_strength");
    }

    /// The shining openings of luminaires.
    int opening_material() {
        if (opening_ >= 0) return opening_;
        JsonValue made = json_object();
        made.add("name", json_text("luminous opening"));
        made.add("emissiveFactor", json_numbers({1.0, 1.0, 1.0}));
        made.add("doubleSided", json_boolean(true));
        return opening_ = writer_.add("materials", std::move(made));
    }

    int lit_material() {
        if (lit_ >= 0) return lit_;
        JsonValue made = json_object();
        made.add("name", json_text("light"));
        made.add("extensions", json_object()).add("KHR_materials_unlit", json_object());
        writer_.use_extension("KHR_materials_unlit");
        return lit_ = writer_.add("materials", std::move(made));
    }

    /// In the axes of glTF, or in a frame of its own that its node turns.
    JsonValue primitive(const TriangleList& list, int its_material, bool own_frame = false) {
        std::vector<Vec3> places;
        for (const Vec3& place : list.places) places.push_back(own_frame ? place : lying(place));
        JsonValue made = json_object();
        made.add("attributes", json_object()).add("POSITION", json_number(writer_.add_places(places)));
        made.add("indices", json_number(writer_.add_indices(list.corners)));
        made.add("material", json_number(its_material));
        return made;
    }

    /// None when there is nothing to show.
    std::optional<int> mesh(const std::string& name, std::vector<JsonValue> primitives) {
        if (primitives.empty()) return std::nullopt;
        JsonValue made = json_object();
        if (!name.empty()) made.add("name", json_text(name));
        made.add("primitives", json_list()).items = std::move(primitives);
        return writer_.add("meshes", std::move(made));
    }

    static JsonValue node(const std::string& name, std::optional<int> mesh) {
        JsonValue made = json_object();
        if (!name.empty()) made.add("name", json_text(name));
        if (mesh) made.add("mesh", json_number(*mesh));
        return made;
    }

    void add_plain(JsonValue made, JsonValue own) {
        made.add("extras", own_extras(std::move(own)));
        plain_.push_back(writer_.add("nodes", std::move(made)));
    }

    void add_room() {
        if (!scene_.room) return;
        std::vector<JsonValue> primitives;
        for (const auto& [id, list] : room_pieces(scene_)) primitives.push_back(primitive(list, material(id, {})));
        add_plain(node(scene_.room->name, mesh(scene_.room->name, std::move(primitives))),
                  own_kind("room", scene_.room->id));
    }

    void add_furniture(const Furniture& furniture) {
        std::vector<JsonValue> primitives;
        const std::vector<TriangleList> lists = furniture_pieces(furniture);
        for (std::size_t k = 0; k < lists.size(); ++k)
            primitives.push_back(primitive(lists[k], material(furniture.parts[k].material, {})));
        JsonValue made = node(furniture.name, mesh(furniture.name, std::move(primitives)));
        made.add("translation", json_of(lying(furniture.position)));
        const double half = 0.5 * furniture.rotation;
        if (half != 0.0) made.add("rotation", json_numbers({0.0, std::sin(half), 0.0, std::cos(half)}));
        add_plain(std::move(made), own_kind("furniture", furniture.id));
    }

    void add_surface(const FreeSurface& surface) {
        TriangleList list;
        list.add(surface.region);
        std::vector<JsonValue> primitives;
        primitives.push_back(primitive(list, material(surface.material, surface.own_exitance)));
        add_plain(node(surface.name, mesh(surface.name, std::move(primitives))), own_kind("surface", surface.id));
    }

    void add_luminaire(const Luminaire& luminaire) {
        std::vector<JsonValue> primitives;
        const TriangleList list = opening_pieces(luminaire, scene_);
        if (!list.corners.empty()) primitives.push_back(primitive(list, opening_material(), true));
        JsonValue made = node(luminaire.name, mesh(luminaire.name, std::move(primitives)));
        made.add("translation", json_of(lying(luminaire.position)));
        // a light of glTF shines along its own -z, which is the luminaire's
        const Mat3 turn = placement(luminaire).rotation;
        const glm::dquat rotation =
            glm::normalize(glm::quat_cast(Mat3{lying(turn[0]), lying(turn[1]), lying(turn[2])}));
        made.add("rotation", json_numbers({rotation.x, rotation.y, rotation.z, rotation.w}));
        JsonValue& extensions = made.add("extensions", json_object());
        extensions.add("KHR_lights_punctual", json_object())
            .add("light", json_number(static_cast<double>(lights_.items.size())));
        JsonValue& shining = extensions.add("EXT_lights_ies", json_object());
        shining.add("light", json_number(profile(luminaire)));
        shining.add("multiplier", json_number(burning_share(luminaire, scene_)));
        lights_.items.push_back(punctual_light(luminaire, scene_));
        add_plain(std::move(made), own_kind("luminaire", luminaire.id));
    }

    int add_lit(const LitSurface& surface) {
        TriangleList list;
        list.places = surface.places;
        for (const auto& triangle : surface.triangles)
            list.corners.insert(list.corners.end(), triangle.begin(), triangle.end());
        JsonValue made = primitive(list, lit_material());
        for (std::size_t k = 0; k < made.keys.size(); ++k)
            if (made.keys[k] == "attributes")
                made.items[k].add("COLOR_0", json_number(writer_.add_colours(surface.colours)));
        std::vector<JsonValue> primitives;
        primitives.push_back(std::move(made));
        const std::string name = name_of(surface.object);
        return writer_.add("nodes", node(name, mesh(name, std::move(primitives))));
    }

    std::string name_of(ObjectId object) const {
        if (scene_.room && scene_.room->id == object) return scene_.room->name;
        for (const Furniture& furniture : scene_.furniture)
            if (furniture.id == object) return furniture.name;
        for (const FreeSurface& surface : scene_.surfaces)
            if (surface.id == object) return surface.name;
        return {};
    }

    const Project& project_;
    const Scene& scene_;
    GltfWriter writer_;
    std::map<std::pair<ObjectId, double>, int> materials_;
    int opening_ = -1, lit_ = -1;
    JsonValue lights_ = json_list(), profiles_ = json_list();
    std::map<std::string, int> profile_of_;
    std::vector<int> plain_;
};

}  // namespace

std::string gltf_file(const Project& project, const LitPicture* picture, bool binary) {
    return Export(project).file(picture, binary);
}

std::optional<Diagnostic> write_gltf(const Project& project, const LitPicture* picture,
                                     const std::filesystem::path& file) {
    if (auto fault = unwritable(json_of(project), file)) return fault;
    return write_text_file(file, gltf_file(project, picture, file.extension() != ".gltf"));
}

}  // namespace hanei
