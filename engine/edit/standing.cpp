#include "engine/edit/standing.h"

#include "engine/edit/furniture_edits.h"
#include "engine/edit/plan_shape.h"
#include "engine/edit/room_faces.h"
#include "engine/edit/several.h"
#include "engine/edit/with_object.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace hanei {
namespace {

double neat(double length) { return std::round(length * 1e9) / 1e9; }

const Furniture* find_furniture(const Scene& scene, ObjectId id) {
    const auto found = std::find_if(scene.furniture.begin(), scene.furniture.end(),
                                    [&](const Furniture& furniture) { return furniture.id == id; });
    return found == scene.furniture.end() ? nullptr : &*found;
}

struct WallBehind {
    RoomFace face;
    double along = 0.0;     ///< m, of the piece's place from the wall's first corner
    double distance = 0.0;  ///< m, of the piece's place from the wall
};

/// The wall that the piece's place is nearest to, of those it stands before.
std::optional<WallBehind> nearest_wall(const Room& room, const Vec3& place) {
    std::optional<WallBehind> nearest;
    for (std::size_t k = 0; k < room.plan.size(); ++k) {
        const std::optional<RoomFace> face = room_face(room, Room::wall_face(static_cast<int>(k)));
        if (!face) continue;
        const double along = face->within(place).x, distance = glm::dot(place - face->origin, face->inward);
        constexpr double through = -0.5;  // m: something pushed that far through a wall still means it
        if (along < 0.0 || along > face->high.x || distance < through) continue;
        if (!nearest || distance < nearest->distance) nearest = WallBehind{*face, along, distance};
    }
    return nearest;
}

double facing(const RoomFace& wall) { return std::atan2(wall.inward.x, -wall.inward.y); }

std::vector<Bounds> boxes_of(const Furniture& furniture) {
    std::vector<Bounds> boxes;
    for (const Part& part : furniture.parts) {
        Scene alone;
        alone.furniture.push_back(furniture);
        alone.furniture.back().parts = {part};
        boxes.push_back(bounds_of(alone));
    }
    return boxes;
}

bool overlap(const Bounds& a, const Bounds& b) {
    constexpr double slack = 1e-3;  // m: what touches does not share space
    for (int k = 0; k < 3; ++k)
        if (a.high[k] - slack <= b.low[k] || b.high[k] - slack <= a.low[k]) return false;
    return true;
}

}  // namespace

std::optional<Scene> turned_to_wall(const Scene& scene, ObjectId piece) {
    const Furniture* const furniture = find_furniture(scene, piece);
    if (furniture == nullptr || !scene.room) return std::nullopt;
    const std::optional<WallBehind> wall = nearest_wall(*scene.room, furniture->position);
    if (!wall) return std::nullopt;
    Scene wished = scene;
    with_object(wished, piece, [&](auto& object, ObjectKind) {
        if constexpr (requires { object.parts; }) object.rotation = facing(wall->face);
    });
    return wished;
}

std::optional<Scene> against_wall(const Scene& scene, ObjectId piece, double within) {
    const Furniture* const furniture = find_furniture(scene, piece);
    if (furniture == nullptr || !scene.room || furniture->parts.empty()) return std::nullopt;
    const std::optional<WallBehind> wall = nearest_wall(*scene.room, furniture->position);
    const Bounds own = own_bounds(*furniture);
    if (!wall || wall->distance - own.high.y > within) return std::nullopt;
    // Kept between the wall's ends where it is long enough: own.high.x lies at its first corner's side.
    double along = wall->along;
    const double first = own.high.x, last = wall->face.high.x + own.low.x;
    if (first <= last) along = std::clamp(along, first, last);
    const Vec3 place = wall->face.origin + along * wall->face.right + own.high.y * wall->face.inward;
    Scene wished = scene;
    with_object(wished, piece, [&](auto& object, ObjectKind) {
        if constexpr (requires { object.parts; }) {
            object.rotation = facing(wall->face);
            object.position = {neat(place.x), neat(place.y), object.position.z};
        }
    });
    return wished;
}

Scene on_floor(Scene scene, std::span<const ObjectId> chosen) {
    const double floor = scene.room ? scene.room->floor_height : 0.0;
    const ObjectIds objects = objects_of(scene, chosen);
    for (const ObjectId id : objects) {
        const ObjectKind kind = kind_of(scene, id);
        if (kind != ObjectKind::furniture && kind != ObjectKind::surface) continue;
        const std::optional<Bounds> bounds = bounds_of_objects(scene, std::array{id});
        if (bounds) scene = moved(std::move(scene), id, {0.0, 0.0, floor - bounds->low.z});
    }
    return scene;
}

bool stands_clear(const Scene& scene, ObjectId piece) {
    const Furniture* const furniture = find_furniture(scene, piece);
    if (furniture == nullptr) return true;
    const std::vector<Bounds> own = boxes_of(*furniture);
    for (const Bounds& box : own) {
        constexpr double slack = 1e-6;
        if (scene.room && !plan_holds(scene.room->plan, Vec2{box.low} + Vec2{slack}, Vec2{box.high} - Vec2{slack}))
            return false;
    }
    for (const Furniture& other : scene.furniture) {
        if (other.id == piece) continue;
        for (const Bounds& theirs : boxes_of(other))
            for (const Bounds& box : own)
                if (overlap(box, theirs)) return false;
    }
    return true;
}

}  // namespace hanei
