#include "engine/edit/edit.h"
#include "engine/edit/hanging.h"
#include "engine/scene/grid_spacing.h"

#include <algorithm>
#include <cmath>

namespace hanei {
namespace {

constexpr double desk_height = 0.75;  // m, the working plane of offices

struct RoomMiddle {
    Vec2 low{0.0}, high{6.0, 4.0};
    double floor = 0.0, ceiling = 2.8;
    Vec3 at(double z) const {
        const Vec2 middle = 0.5 * (low + high);
        return {std::round(middle.x * 10.0) / 10.0, std::round(middle.y * 10.0) / 10.0, z};
    }
};

RoomMiddle middle_of(const Scene& scene) {
    RoomMiddle middle;
    if (!scene.room || scene.room->plan.empty()) return middle;
    middle.low = middle.high = scene.room->plan.front();
    for (const Vec2& corner : scene.room->plan) {
        middle.low = glm::min(middle.low, corner);
        middle.high = glm::max(middle.high, corner);
    }
    middle.floor = scene.room->floor_height;
    middle.ceiling = middle.floor + scene.room->height;
    return middle;
}

template <class List>
std::string numbered(const char* what, const List& list) {
    return std::string(what) + " " + std::to_string(list.size() + 1);
}

Added with_luminaire(Scene scene, Luminaire luminaire) {
    luminaire.id = scene.new_id();
    const ObjectId id = luminaire.id;
    scene.luminaires.push_back(std::move(luminaire));
    return {std::move(scene), id};
}

ObjectId some_material(Scene& scene) {
    if (!scene.materials.empty()) return scene.materials.back().id;
    const ObjectId id = scene.new_id();
    scene.materials.push_back({id, "Grey", 0.5, {}});
    return id;
}

}  // namespace

Added with_point_luminaire(Scene scene) {
    const RoomMiddle middle = middle_of(scene);
    Luminaire luminaire;
    luminaire.name = numbered("Point", scene.luminaires);
    luminaire.position = middle.at(std::max(middle.floor, middle.ceiling - 0.5));
    luminaire.output = LuminousFlux{1500.0};
    return with_luminaire(std::move(scene), std::move(luminaire));
}

Added with_line_luminaire(Scene scene) {
    const RoomMiddle middle = middle_of(scene);
    Luminaire luminaire;
    luminaire.name = numbered("Line", scene.luminaires);
    luminaire.position = middle.at(std::max(middle.floor, middle.ceiling - 0.1));
    luminaire.opening = LineOpening{{-0.6, 0.0, 0.0}, {0.6, 0.0, 0.0}};
    luminaire.output = LuminousFlux{3000.0};
    return with_luminaire(std::move(scene), std::move(luminaire));
}

Added with_panel_luminaire(Scene scene) {
    const RoomMiddle middle = middle_of(scene);
    Luminaire luminaire;
    luminaire.name = numbered("Panel", scene.luminaires);
    luminaire.position = middle.at(std::max(middle.floor, middle.ceiling - 0.02));
    luminaire.opening =
        PolygonOpening{Region{{{-0.3, -0.3, 0.0}, {-0.3, 0.3, 0.0}, {0.3, 0.3, 0.0}, {0.3, -0.3, 0.0}}, {}}};
    luminaire.output = LuminousFlux{3600.0};
    return with_luminaire(std::move(scene), std::move(luminaire));
}

Added with_measured_luminaire(Scene scene, Photometry photometry) {
    const Vec2 middle(middle_of(scene).at(0.0));
    return with_measured_luminaires(std::move(scene), {std::move(photometry)}, middle);
}

Added with_box(Scene scene) {
    const RoomMiddle middle = middle_of(scene);
    Furniture box;
    box.id = scene.new_id();
    box.name = numbered("Box", scene.furniture);
    box.position = middle.at(middle.floor);
    Part part;
    part.shape = BoxShape{{1.2, 0.6, desk_height}};
    part.material = some_material(scene);
    box.parts.push_back(part);
    const ObjectId id = box.id;
    scene.furniture.push_back(std::move(box));
    return {std::move(scene), id};
}

Added with_grid(Scene scene) {
    const RoomMiddle middle = middle_of(scene);
    // EN 12464-1 leaves a border of 0.5 m along the walls out of a room's task area.
    const double border = std::min(0.5, 0.2 * std::min(middle.high.x - middle.low.x, middle.high.y - middle.low.y));
    CalculationGrid grid;
    grid.id = scene.new_id();
    grid.name = numbered("Grid", scene.grids);
    grid.corner = {middle.low.x + border, middle.low.y + border, middle.floor + desk_height};
    grid.along = {middle.high.x - middle.low.x - 2.0 * border, 0.0, 0.0};
    grid.across = {0.0, middle.high.y - middle.low.y - 2.0 * border, 0.0};
    constexpr double usual = 0.5;
    grid.spacing = usual;
    constexpr double many = 1e4;
    if (grid_points(grid) > many) grid.spacing = std::max(usual, standard_spacing(grid));
    const ObjectId id = grid.id;
    scene.grids.push_back(std::move(grid));
    return {std::move(scene), id};
}

Added with_calculation_point(Scene scene) {
    const RoomMiddle middle = middle_of(scene);
    CalculationPoint point;
    point.id = scene.new_id();
    point.name = numbered("Point", scene.points);
    point.position = middle.at(middle.floor + desk_height);
    const ObjectId id = point.id;
    scene.points.push_back(std::move(point));
    return {std::move(scene), id};
}

Scene empty_room() {
    Scene scene;
    scene.title = "New room";
    const auto material = [&](const char* name, double reflectance) {
        const ObjectId id = scene.new_id();
        scene.materials.push_back({id, name, reflectance, {}});
        return id;
    };
    Room room;
    room.id = scene.new_id();
    room.name = "Room";
    room.plan = {{0.0, 0.0}, {6.0, 0.0}, {6.0, 4.0}, {0.0, 4.0}};
    room.ceiling_material = material("Ceiling", 0.7);
    room.wall_materials.assign(4, material("Walls", 0.5));
    room.floor_material = material("Floor", 0.2);
    scene.room = std::move(room);
    return scene;
}

}  // namespace hanei
