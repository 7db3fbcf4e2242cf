#include "engine/edit/reflectances.h"

#include "engine/scene/colour.h"
#include "engine/scene/faces.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <string>

namespace hanei {
namespace {

constexpr std::array presets{
    ReflectancePreset{"80/50/30", "Light ceiling and floor", {0.8, 0.5, 0.3}},
    ReflectancePreset{"70/50/20", "The usual office: what most luminaire tables are stated for", {0.7, 0.5, 0.2}},
    ReflectancePreset{"70/30/20", "Darker walls: shelves, wood, windows by night", {0.7, 0.3, 0.2}},
    ReflectancePreset{"50/30/10", "Dark rooms and workshops", {0.5, 0.3, 0.1}},
    ReflectancePreset{"80/80/30", "White walls", {0.8, 0.8, 0.3}},
    ReflectancePreset{"0/0/0", "Black: direct light alone", {0.0, 0.0, 0.0}},
};

/// Calls `visit` with the material of everything that has one.
template <class SceneType, class Visit>
void for_each_material(SceneType& scene, const Visit& visit) {
    if (scene.room) {
        visit(scene.room->floor_material);
        visit(scene.room->ceiling_material);
        for (auto& material : scene.room->wall_materials) visit(material);
        for (auto& area : scene.room->sub_areas) visit(area.material);
    }
    for (auto& furniture : scene.furniture)
        for (auto& part : furniture.parts) visit(part.material);
    for (auto& surface : scene.surfaces) visit(surface.material);
}

/// A material that these faces of the room alone use; they are covered with it afterwards.
Material& own_material(Scene& scene, const char* name, const std::vector<ObjectId*>& faces) {
    const ObjectId first = *faces.front();
    const bool alike = std::all_of(faces.begin(), faces.end(), [&](const ObjectId* face) { return *face == first; });
    const bool alone = alike && users_of_material(scene, first) == static_cast<int>(faces.size());
    const auto present = std::find_if(scene.materials.begin(), scene.materials.end(),
                                      [&](const Material& material) { return material.id == first; });
    if (alone && present != scene.materials.end()) return *present;
    Material material;
    material.id = scene.new_id();
    material.name = name;
    const auto named = [&](const Material& other) { return other.name == material.name; };
    for (int k = 2; std::any_of(scene.materials.begin(), scene.materials.end(), named); ++k)
        material.name = std::string(name) + " " + std::to_string(k);
    for (ObjectId* face : faces) *face = material.id;
    scene.materials.push_back(std::move(material));
    return scene.materials.back();
}

void reflect(Material& material, double reflectance) {
    material.reflectance = reflectance;
    material.tint = possible_tint(material.tint, reflectance);
}

double reflectance_of(const Scene& scene, ObjectId id) {
    const Material* const material = find_material(scene, id);
    return material == nullptr ? 0.0 : material->reflectance;
}

}  // namespace

std::span<const ReflectancePreset> reflectance_presets() { return presets; }

std::optional<Reflectances> reflectances_of(std::string_view text) {
    double ceiling = 0.0, walls = 0.0, floor = 0.0;
    int used = 0;
    const std::string copy(text);
    if (std::sscanf(copy.c_str(), "%lf/%lf/%lf%n", &ceiling, &walls, &floor, &used) != 3) return std::nullopt;
    if (used != static_cast<int>(copy.size())) return std::nullopt;
    for (const double percent : {ceiling, walls, floor})
        if (!(percent >= 0.0 && percent <= 100.0)) return std::nullopt;
    return Reflectances{ceiling / 100.0, walls / 100.0, floor / 100.0};
}

Scene with_reflectances(Scene scene, const Reflectances& reflectances) {
    if (!scene.room) return scene;
    std::vector<ObjectId*> walls;
    for (ObjectId& wall : scene.room->wall_materials) walls.push_back(&wall);
    reflect(own_material(scene, "Ceiling", {&scene.room->ceiling_material}), reflectances.ceiling);
    if (!walls.empty()) reflect(own_material(scene, "Walls", walls), reflectances.walls);
    reflect(own_material(scene, "Floor", {&scene.room->floor_material}), reflectances.floor);
    return scene;
}

std::optional<Reflectances> reflectances_of(const Scene& scene) {
    if (!scene.room) return std::nullopt;
    const Room& room = *scene.room;
    double length = 0.0, sum = 0.0;
    for (std::size_t k = 0; k < room.wall_materials.size() && k < room.plan.size(); ++k) {
        const double wall = glm::distance(room.plan[k], room.plan[(k + 1) % room.plan.size()]);
        length += wall;
        sum += wall * reflectance_of(scene, room.wall_materials[k]);
    }
    return Reflectances{reflectance_of(scene, room.ceiling_material), length > 0.0 ? sum / length : 0.0,
                        reflectance_of(scene, room.floor_material)};
}

int users_of_material(const Scene& scene, ObjectId material) {
    int users = 0;
    for_each_material(scene, [&](ObjectId used) { users += used == material ? 1 : 0; });
    return users;
}

Scene with_material_replaced(Scene scene, ObjectId material, ObjectId other) {
    for_each_material(scene, [&](ObjectId& used) {
        if (used == material) used = other;
    });
    return scene;
}

Scene without_unused_materials(Scene scene) {
    std::vector<ObjectId> used;
    for_each_material(scene, [&](ObjectId material) { used.push_back(material); });
    std::sort(used.begin(), used.end());
    std::erase_if(scene.materials,
                  [&](const Material& material) { return !std::binary_search(used.begin(), used.end(), material.id); });
    return scene;
}

}  // namespace hanei
