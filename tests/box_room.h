/// Small rooms that tests furnish as they need.
#pragma once

#include "engine/scene/scene.h"

#include <numbers>

namespace hanei::test {

/// A closed box room with one reflectance everywhere, one corner at the origin.
inline Scene box_room(const Vec3& size, double reflectance) {
    Scene scene;
    scene.title = "test room";
    const Material material{scene.new_id(), "wall", reflectance, {}};
    scene.materials.push_back(material);
    Room room;
    room.id = scene.new_id();
    room.plan = {{0.0, 0.0}, {size.x, 0.0}, {size.x, size.y}, {0.0, size.y}};
    room.height = size.z;
    room.floor_material = room.ceiling_material = material.id;
    room.wall_materials.assign(4, material.id);
    scene.room = room;
    return scene;
}

/// A horizontal diffuse panel that shines down, centred at `middle`.
inline Luminaire panel(Scene& scene, const Vec3& middle, Vec2 size, double flux_lm) {
    Luminaire luminaire;
    luminaire.id = scene.new_id();
    luminaire.position = middle;
    const double x = size.x / 2.0, y = size.y / 2.0;
    luminaire.opening = PolygonOpening{{{{-x, -y, 0.0}, {-x, y, 0.0}, {x, y, 0.0}, {x, -y, 0.0}}, {}}};
    luminaire.output = LuminousFlux{flux_lm};
    return luminaire;
}

inline Luminaire point_source(Scene& scene, const Vec3& position, double flux_lm) {
    Luminaire luminaire;
    luminaire.id = scene.new_id();
    luminaire.position = position;
    luminaire.output = LuminousFlux{flux_lm};
    return luminaire;
}

/// A box of furniture standing at `position` (middle of its foot).
inline Furniture box(Scene& scene, const Vec3& position, const Vec3& size) {
    Furniture furniture;
    furniture.id = scene.new_id();
    furniture.position = position;
    Part part;
    part.shape = BoxShape{size};
    part.material = scene.materials.front().id;
    furniture.parts.push_back(part);
    return furniture;
}

inline CalculationPoint point(Scene& scene, const Vec3& position, const Vec3& normal = {0.0, 0.0, 1.0}) {
    return {scene.new_id(), "point", position, normal, {}};
}

/// A 6 x 4 x 2.8 m room with a desk-high box, two panels and points on the floor and above the box.
inline Scene small_office() {
    Scene scene = box_room({6.0, 4.0, 2.8}, 0.5);
    scene.furniture.push_back(box(scene, {2.0, 2.0, 0.0}, {1.6, 0.8, 0.72}));
    scene.luminaires.push_back(panel(scene, {1.8, 2.0, 2.79}, {1.2, 0.6}, 3600.0));
    scene.luminaires.push_back(panel(scene, {4.2, 2.0, 2.79}, {1.2, 0.6}, 3600.0));
    scene.points.push_back(point(scene, {1.0, 2.0, 0.0}));
    scene.points.push_back(point(scene, {2.0, 2.0, 0.72}));
    scene.points.push_back(point(scene, {3.1, 2.0, 0.0}));
    return scene;
}

}  // namespace hanei::test
