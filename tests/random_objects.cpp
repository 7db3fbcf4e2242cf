#include "tests/random_scene.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace hanei::test {
namespace {

ObjectId any_material(const Scene& scene, Dice& dice) {
    return scene.materials[static_cast<std::size_t>(dice.below(static_cast<int>(scene.materials.size())))].id;
}

SolidShape tetrahedron(Dice& dice) {
    const double a = dice.in(0.2, 1.0), b = dice.in(0.2, 1.0), h = dice.logarithmic(1e-3, 1.5);
    return {{{0.0, 0.0, 0.0}, {a, 0.0, 0.0}, {0.0, b, 0.0}, {0.1, 0.1, h}},
            {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}}};
}

/// An L of unit sides: not convex.
SolidShape angled_prism(Dice& dice) {
    const double a = dice.in(0.2, 0.8), h = dice.in(0.2, 1.5);
    const std::vector<Vec2> plan{{0.0, 0.0}, {1.0, 0.0}, {1.0, a}, {a, a}, {a, 1.0}, {0.0, 1.0}};
    SolidShape solid;
    const int n = static_cast<int>(plan.size());
    for (const double z : {0.0, h})
        for (const Vec2& corner : plan) solid.vertices.emplace_back(corner, z);
    solid.faces.resize(2);
    for (int k = 0; k < n; ++k) {
        solid.faces[0].push_back(n - 1 - k);
        solid.faces[1].push_back(n + k);
        const int next = (k + 1) % n;
        solid.faces.push_back({k, next, n + next, n + k});
    }
    return solid;
}

struct Placed {
    Vec3 position, size;
};

/// Beside, within, through or on the box before.
Placed next_to(const Placed& before, Dice& dice) {
    const Vec3 size{dice.in(0.1, 1.2), dice.in(0.1, 1.2), dice.in(0.1, 1.5)};
    const double side = 0.5 * (before.size.x + size.x);
    switch (dice.below(6)) {
        case 0:
            return {before.position + Vec3{side, 0.0, 0.0}, size};  // touches
        case 1:
            return {before.position + Vec3{side + dice.logarithmic(1e-9, 1e-2), 0.0, 0.0}, size};  // a gap
        case 2:
            return {before.position + Vec3{0.0, 0.0, before.size.z}, size};  // stands on it
        case 3:
            return {before.position + Vec3{0.5 * side, 0.1, 0.0}, size};  // goes through it
        case 4:
            return {before.position + Vec3{0.0, 0.0, 0.25 * before.size.z}, 0.5 * before.size};  // lies within
        default:
            return before;  // listed twice
    }
}

Placed alone(Dice& dice, const Vec3& room) {
    Vec3 place = dice.in_box(Vec3{0.0}, room), size{dice.in(0.1, 1.5), dice.in(0.1, 1.5), dice.in(0.1, 2.0)};
    place.z = dice.chance(0.7) ? 0.0 : place.z;
    switch (dice.below(8)) {
        case 0:
            return {{0.5 * size.x, 0.5 * size.y, 0.0}, size};  // in a corner
        case 1:
            return {place, {0.01, dice.logarithmic(1e-3, 0.02), 1.5}};  // a stick
        case 2:
            return {place, {dice.logarithmic(1e-6, 1e-2), 1.0, 1.0}};  // a board
        case 3:
            return {{0.5 * room.x, 0.5 * room.y, 0.0}, {0.01, room.y, room.z}};  // cuts the room in two
        case 4:
            return {place, {1.0, 1.0, dice.logarithmic(1e-4, 1e-2)}};  // a mat
        case 5:
            return {{place.x, place.y, room.z - size.z}, size};  // hangs from the ceiling
        default:
            return {place, size};
    }
}

Furniture box_at(Scene& scene, Dice& dice, const Placed& at) {
    Furniture furniture;
    furniture.id = scene.new_id();
    furniture.name = "box " + std::to_string(furniture.id.value);
    furniture.position = at.position;
    Part part;
    part.shape = BoxShape{at.size};
    if (dice.chance(0.15)) part.shape = dice.chance(0.5) ? tetrahedron(dice) : angled_prism(dice);
    part.material = any_material(scene, dice);
    furniture.parts.push_back(part);
    if (dice.chance(0.3)) furniture.rotation = dice.pick({0.5 * std::numbers::pi, dice.in(0.0, 6.0), 1e-9});
    return furniture;
}

Polygon rectangle(const Vec3& corner, const Vec3& along, const Vec3& across) {
    return {corner, corner + along, corner + along + across, corner + across};
}

Region sheet(Dice& dice, const Vec3& room) {
    const Vec3 corner = dice.in_box(0.1 * room, 0.6 * room);
    const Vec3 along = dice.in(0.3, 1.0) * dice.direction();
    const Vec3 across = dice.in(0.3, 1.0) * glm::normalize(glm::cross(along, dice.direction()));
    switch (dice.below(7)) {
        case 0:
            return {rectangle(corner, {1.0, 0.0, 0.0}, {0.0, 0.7, 0.0}), {}};
        case 1:
            return {rectangle(corner, {0.0, 1.0, 0.0}, {0.0, 0.0, 0.7}), {}};
        case 2:
            return {{corner, corner + along, corner + across}, {}};
        case 3:
            return {rectangle(corner, along, dice.logarithmic(1e-6, 1e-2) * across), {}};
        case 4:
            return {rectangle({corner.x, corner.y, 0.0}, {0.8, 0.0, 0.0}, {0.0, 0.8, 0.0}), {}};  // on the floor
        case 5: {
            const Polygon hole = rectangle(corner + Vec3{0.2, 0.2, 0.0}, {0.0, 0.3, 0.0}, {0.3, 0.0, 0.0});
            return {rectangle(corner, {1.0, 0.0, 0.0}, {0.0, 0.8, 0.0}), {hole}};
        }
        default:
            return {rectangle(corner, along, across), {}};
    }
}

}  // namespace

void add_random_furniture(Scene& scene, Dice& dice, const Vec3& size) {
    const int count = dice.below(6);
    Placed last = alone(dice, size);
    for (int k = 0; k < count; ++k) {
        if (k > 0) last = dice.chance(0.5) ? next_to(last, dice) : alone(dice, size);
        scene.furniture.push_back(box_at(scene, dice, last));
    }
}

void add_random_surfaces(Scene& scene, Dice& dice, const Vec3& size) {
    for (int k = 1 + dice.below(4); k > 0; --k) {
        FreeSurface surface{scene.new_id(), "sheet", sheet(dice, size), any_material(scene, dice), {0.0}, {}};
        if (!scene.surfaces.empty() && dice.chance(0.3)) {  // the one before, or shifted in its plane
            surface.region = scene.surfaces.back().region;
            const Vec3 shift = dice.pick({0.0, 0.3}) * (surface.region.outline[1] - surface.region.outline[0]);
            for (Vec3& corner : surface.region.outline) corner += shift;
            for (Polygon& hole : surface.region.holes)
                for (Vec3& corner : hole) corner += shift;
        }
        if (dice.chance(0.15)) surface.own_exitance = {dice.logarithmic(1.0, 1e4)};
        scene.surfaces.push_back(surface);
    }
}

}  // namespace hanei::test
