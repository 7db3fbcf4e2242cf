#include "tests/random_scenes/random_room.h"

#include "engine/scene/colour.h"

#include <cstdlib>

namespace hanei::test {
namespace {

ObjectId random_material(Scene& scene, Dice& dice, double most) {
    Material material;
    material.id = scene.new_id();
    material.reflectance = dice.in(0.0, most);
    if (dice.chance(0.3)) {
        const Vec3 screen{dice.in(0.1, 1.0), dice.in(0.1, 1.0), dice.in(0.1, 1.0)};
        const Vec3 tint = tint_from_srgb(screen, material.reflectance);
        material.tint = tint;
    }
    scene.materials.push_back(material);
    return material.id;
}

}  // namespace

Scene random_room(Dice& dice) {
    Scene scene;
    const Vec3 size{dice.in(2.0, 8.0), dice.in(2.0, 8.0), dice.in(2.2, 4.0)};
    const double most = dice.pick({0.05, 0.5, 0.9});
    Room room;
    room.id = scene.new_id();
    room.plan = {{0.0, 0.0}, {size.x, 0.0}, {size.x, size.y}, {0.0, size.y}};
    room.height = size.z;
    room.floor_material = random_material(scene, dice, most);
    room.ceiling_material = random_material(scene, dice, most);
    for (int wall = 0; wall < 4; ++wall) room.wall_materials.push_back(random_material(scene, dice, most));
    scene.room = std::move(room);
    for (int count = 1 + dice.below(5); count > 0; --count) {
        Furniture box;
        box.id = scene.new_id();
        const Vec3 sides{dice.logarithmic(0.05, 1.2), dice.logarithmic(0.05, 1.2), dice.logarithmic(0.05, 1.8)};
        box.position = {dice.in(0.9, size.x - 0.9), dice.in(0.9, size.y - 0.9),
                        dice.chance(0.7) ? 0.0 : dice.in(0.0, size.z - 2.0)};
        box.rotation = dice.in(0.0, 3.0);
        Part part;
        part.shape = BoxShape{sides};
        part.material = random_material(scene, dice, dice.pick({0.1, 0.9}));
        box.parts.push_back(part);
        scene.furniture.push_back(std::move(box));
    }
    for (int count = 1 + dice.below(3); count > 0; --count) {
        Luminaire lamp;
        lamp.id = scene.new_id();
        lamp.position = {dice.in(0.7, size.x - 0.7), dice.in(0.7, size.y - 0.7), size.z - dice.in(0.02, 0.15)};
        lamp.output = LuminousFlux{dice.in(100.0, 4000.0)};
        const int kind = dice.below(3);
        if (kind == 0) {
            const double x = dice.in(0.05, 0.6), y = dice.in(0.05, 0.6);
            lamp.opening = PolygonOpening{{{{-x, -y, 0}, {-x, y, 0}, {x, y, 0}, {x, -y, 0}}, {}}};
        } else if (kind == 1) {
            lamp.opening = LineOpening{{-0.6, 0.0, 0.0}, {0.6, 0.0, 0.0}};
        } else {
            lamp.distribution = CosinePower{dice.in(1.0, 8.0)};
        }
        if (dice.chance(0.3)) lamp.colour_temperature = dice.in(2500.0, 6500.0);
        scene.luminaires.push_back(std::move(lamp));
    }
    for (int count = 0; count < 12; ++count) {
        CalculationPoint point;
        point.id = scene.new_id();
        point.position = dice.in_box({0.05, 0.05, 0.0}, {size.x - 0.05, size.y - 0.05, size.z - 0.2});
        if (dice.chance(0.5)) point.position.z = dice.chance(0.5) ? 0.0 : 0.75;
        point.normal = point.position.z == 0.0 || dice.chance(0.7) ? Vec3{0.0, 0.0, 1.0} : dice.direction();
        scene.points.push_back(point);
    }
    return scene;
}

std::uint64_t number_of(const char* variable, std::uint64_t usual) {
    const char* const wished = std::getenv(variable);
    return wished != nullptr ? std::strtoull(wished, nullptr, 10) : usual;
}

}  // namespace hanei::test
