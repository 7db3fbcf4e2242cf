#include "engine/edit/room_faces.h"

#include "engine/edit/plan_shape.h"
#include "engine/geometry/polygon.h"

#include <cmath>

namespace hanei {
namespace {

std::size_t wall_of(int face) { return static_cast<std::size_t>(face - Room::wall_face(0)); }

}  // namespace

Vec2 RoomFace::within(const Vec3& place) const {
    return {glm::dot(place - origin, right), glm::dot(place - origin, up)};
}

int face_count(const Room& room) { return Room::wall_face(static_cast<int>(room.plan.size())); }

double wall_length(const Room& room, std::size_t wall) {
    return glm::distance(room.plan[wall], room.plan[(wall + 1) % room.plan.size()]);
}

std::optional<RoomFace> room_face(const Room& room, int face) {
    if (face < 0 || face >= face_count(room) || room.plan.size() < 3) return std::nullopt;
    RoomFace made;
    if (face < Room::wall_face(0)) {
        made.low = made.high = room.plan.front();
        for (const Vec2& corner : room.plan) {
            made.low = glm::min(made.low, corner);
            made.high = glm::max(made.high, corner);
        }
        made.origin.z = room.floor_height + (face == Room::ceiling_face ? room.height : 0.0);
        made.inward.z = face == Room::ceiling_face ? -1.0 : 1.0;
        return made;
    }
    const std::size_t wall = wall_of(face);
    const double length = wall_length(room, wall);
    if (!(length > 0.0)) return std::nullopt;
    const Vec2 along = (room.plan[(wall + 1) % room.plan.size()] - room.plan[wall]) / length;
    made.origin = Vec3{room.plan[wall], room.floor_height};
    made.right = Vec3{along, 0.0};
    made.up = Vec3{0.0, 0.0, 1.0};
    made.inward = Vec3{-along.y, along.x, 0.0};
    made.high = {length, room.height};
    return made;
}

std::string name_of_face(int face) {
    if (face == Room::floor_face) return "Floor";
    if (face == Room::ceiling_face) return "Ceiling";
    return "Wall " + std::to_string(wall_of(face) + 1);
}

double area_of_face(const Room& room, int face) {
    if (face < Room::wall_face(0)) return std::abs(signed_area(room.plan));
    return wall_length(room, wall_of(face)) * room.height;
}

ObjectId& material_of_face(Room& room, int face) {
    if (face == Room::floor_face) return room.floor_material;
    if (face == Room::ceiling_face) return room.ceiling_material;
    return room.wall_materials[wall_of(face)];
}

ObjectId material_of_face(const Room& room, int face) {
    Room copy = room;
    return material_of_face(copy, face);
}

const SubArea* sub_area_at(const Room& room, int face, const Vec2& at) {
    for (auto area = room.sub_areas.rbegin(); area != room.sub_areas.rend(); ++area) {
        const bool inside = at.x >= area->low.x && at.x <= area->high.x && at.y >= area->low.y && at.y <= area->high.y;
        if (area->face == face && inside) return &*area;
    }
    return nullptr;
}

std::optional<FacePlace> face_under(const Room& room, const Vec3& from, const Vec3& direction) {
    std::optional<FacePlace> nearest;
    for (int face = 0; face < face_count(room); ++face) {
        const std::optional<RoomFace> plane = room_face(room, face);
        if (!plane) continue;
        const double sinks = -glm::dot(direction, plane->inward);
        if (!(sinks > 1e-9)) continue;  // seen from behind, or end on
        const double distance = glm::dot(from - plane->origin, plane->inward) / sinks;
        if (!(distance > 0.0) || (nearest && distance >= nearest->distance)) continue;
        const Vec2 at = plane->within(from + distance * direction);
        const bool wall = face >= Room::wall_face(0);
        const bool inside = wall ? at.x >= 0.0 && at.y >= 0.0 && at.x <= plane->high.x && at.y <= plane->high.y
                                 : plan_holds(room.plan, at);
        if (inside) nearest = FacePlace{face, at, distance};
    }
    return nearest;
}

}  // namespace hanei
