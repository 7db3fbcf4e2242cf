/// The faces of the room as sub-areas count them: x along a wall from its first corner, y up from the
/// floor; on floor and ceiling the plan's own x and y.
#pragma once

#include "engine/scene/scene.h"

#include <optional>
#include <string>

namespace hanei {

struct RoomFace {
    Vec3 origin{0.0};  ///< of the face's coordinates, in the scene
    Vec3 right{1.0, 0.0, 0.0}, up{0.0, 1.0, 0.0};
    Vec3 inward{0.0, 0.0, 1.0};  ///< unit, into the room
    Vec2 low{0.0}, high{0.0};    ///< bounds of the face in its coordinates

    Vec3 point(const Vec2& at) const { return origin + at.x * right + at.y * up; }
    Vec2 within(const Vec3& place) const;
    Vec2 size() const { return high - low; }
};

/// How many faces a room has: floor, ceiling and its walls.
int face_count(const Room& room);
/// Nothing when the room has no such face.
std::optional<RoomFace> room_face(const Room& room, int face);
/// "Floor", "Ceiling", "Wall 1"; walls are counted from 1 as panels show them.
std::string name_of_face(int face);

double wall_length(const Room& room, std::size_t wall);
double area_of_face(const Room& room, int face);  ///< m², sub-areas included
ObjectId& material_of_face(Room& room, int face);
ObjectId material_of_face(const Room& room, int face);

/// The sub-area seen at this place of a face: the last that holds it.
const SubArea* sub_area_at(const Room& room, int face, const Vec2& at);

/// Where a ray first meets the room from inside; backs of faces are looked through.
struct FacePlace {
    int face = 0;
    Vec2 at{0.0};  ///< in the face's coordinates
    double distance = 0.0;
};
std::optional<FacePlace> face_under(const Room& room, const Vec3& from, const Vec3& direction);

}  // namespace hanei
