/// Small rooms that several test programs share.
#pragma once

#include "engine/scene/scene.h"

#include <utility>
#include <vector>

namespace hanei::sample {

inline ObjectId material(Scene& scene, double reflectance) {
    const ObjectId id = scene.new_id();
    scene.materials.push_back({id, "", reflectance, {}});
    return id;
}

/// A prism with one reflectance on all faces.
inline Scene prism(std::vector<Vec2> plan, double height, double reflectance) {
    Scene scene;
    Room room;
    room.id = scene.new_id();
    const ObjectId all = material(scene, reflectance);
    room.floor_material = room.ceiling_material = all;
    room.wall_materials.assign(plan.size(), all);
    room.plan = std::move(plan);
    room.height = height;
    scene.room = std::move(room);
    return scene;
}

inline Scene box_room(double x, double y, double z, double reflectance = 0.5) {
    return prism({{0.0, 0.0}, {x, 0.0}, {x, y}, {0.0, y}}, z, reflectance);
}

/// An L of two corridors, 1.5 m wide and 4 m long outside.
inline Scene l_room(double reflectance = 0.5) {
    return prism({{0.0, 0.0}, {4.0, 0.0}, {4.0, 1.5}, {1.5, 1.5}, {1.5, 4.0}, {0.0, 4.0}}, 2.5, reflectance);
}

/// A box standing at `position` (the middle of its underside), turned about z.
inline ObjectId add_box(Scene& scene, Vec3 position, Vec3 size, double rotation = 0.0, double reflectance = 0.5) {
    Furniture furniture;
    furniture.id = scene.new_id();
    furniture.position = position;
    furniture.rotation = rotation;
    Part part;
    part.shape = BoxShape{size};
    part.material = material(scene, reflectance);
    furniture.parts.push_back(part);
    scene.furniture.push_back(furniture);
    return furniture.id;
}

/// A table: a top 30 mm thick on two panels, as one piece of furniture.
inline void add_table(Scene& scene, Vec3 position, double rotation = 0.0) {
    Furniture table;
    table.id = scene.new_id();
    table.position = position;
    table.rotation = rotation;
    const ObjectId wood = material(scene, 0.4);
    const auto part = [&](Vec3 at, Vec3 size) {
        Part p;
        p.shape = BoxShape{size};
        p.position = at;
        p.material = wood;
        table.parts.push_back(p);
    };
    part({0.0, 0.0, 0.69}, {1.8, 0.8, 0.03});
    part({-0.825, 0.0, 0.0}, {0.05, 0.7, 0.69});
    part({0.825, 0.0, 0.0}, {0.05, 0.7, 0.69});
    scene.furniture.push_back(table);
}

/// An L of 1.2 x 1 m, its legs 0.5 m wide, as one part; its corner stands at `position`. Face 0 is the
/// underside, 1 the top, 2 to 7 the sides.
inline ObjectId add_l_shape(Scene& scene, Vec3 position, double height) {
    const std::vector<Vec2> plan = {{0, 0}, {1.2, 0}, {1.2, 0.5}, {0.5, 0.5}, {0.5, 1}, {0, 1}};
    SolidShape shape;
    for (const double z : {0.0, height}) {
        for (const Vec2& corner : plan) shape.vertices.emplace_back(corner, z);
    }
    shape.faces = {{5, 4, 3, 2, 1, 0}, {6, 7, 8, 9, 10, 11}};
    for (int k = 0; k < 6; ++k) shape.faces.push_back({k, (k + 1) % 6, 6 + (k + 1) % 6, 6 + k});
    Furniture furniture;
    furniture.id = scene.new_id();
    furniture.position = position;
    Part part;
    part.shape = std::move(shape);
    part.material = material(scene, 0.5);
    furniture.parts.push_back(std::move(part));
    scene.furniture.push_back(std::move(furniture));
    return scene.furniture.back().id;
}

inline ObjectId add_surface(Scene& scene, Polygon outline, double reflectance = 0.5, double own_exitance = 0.0) {
    FreeSurface surface;
    surface.id = scene.new_id();
    surface.region.outline = std::move(outline);
    surface.material = material(scene, reflectance);
    surface.own_exitance = {own_exitance};
    scene.surfaces.push_back(surface);
    return surface.id;
}

/// The faces of an upright box as free surfaces looking outward: bottom, top, and four sides, those
/// whose bit is set in `faces`.
inline void add_box_of_surfaces(Scene& scene, Vec3 low, Vec3 high, unsigned faces) {
    const auto p = [&](int x, int y, int z) {
        return Vec3(x ? high.x : low.x, y ? high.y : low.y, z ? high.z : low.z);
    };
    const Polygon all[6] = {
        {p(0, 0, 0), p(0, 1, 0), p(1, 1, 0), p(1, 0, 0)}, {p(0, 0, 1), p(1, 0, 1), p(1, 1, 1), p(0, 1, 1)},
        {p(0, 0, 0), p(1, 0, 0), p(1, 0, 1), p(0, 0, 1)}, {p(1, 1, 0), p(0, 1, 0), p(0, 1, 1), p(1, 1, 1)},
        {p(0, 1, 0), p(0, 0, 0), p(0, 0, 1), p(0, 1, 1)}, {p(1, 0, 0), p(1, 1, 0), p(1, 1, 1), p(1, 0, 1)}};
    for (unsigned k = 0; k < 6; ++k) {
        if (faces & (1U << k)) add_surface(scene, all[k]);
    }
}
inline constexpr unsigned closed_box = 63U;
inline constexpr unsigned without_bottom = 62U;
inline constexpr unsigned sides_only = 60U;

/// A room 8 m x 6 m x 3 m like a computer room: cabinets, a table with a terminal on it, a box
/// turned by 30 degrees, a cabinet 20 mm off the wall, two boxes with a gap of 1 mm.
inline Scene computer_room(double reflectance = 0.5) {
    Scene scene = box_room(8.0, 6.0, 3.0, reflectance);
    for (int k = 0; k < 4; ++k) add_box(scene, {1.4 + 0.95 * k, 5.35, 0.0}, {0.8, 0.7, 1.8});
    add_table(scene, {3.5, 2.8, 0.0});
    add_box(scene, {3.45, 2.95, 0.72}, {0.5, 0.35, 0.38});
    add_box(scene, {6.6, 1.4, 0.0}, {1.2, 0.6, 0.7}, 0.5235987755982988);
    add_box(scene, {7.63, 3.5, 0.0}, {0.7, 0.6, 1.6});
    add_box(scene, {1.0, 1.0, 0.0}, {0.5, 0.5, 0.5});
    add_box(scene, {1.0, 1.0, 0.501}, {0.5, 0.5, 0.5});
    return scene;
}

}  // namespace hanei::sample
