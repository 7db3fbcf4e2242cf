/// Doors, windows, boards: parts of the room's faces with materials of their own.
#pragma once

#include "engine/edit/edit.h"
#include "engine/edit/room_faces.h"

#include <span>
#include <string_view>

namespace hanei {

struct SubAreaKind {
    std::string_view kind;      ///< "door", on the command line
    std::string_view label;     ///< "Door"
    std::string_view help;      ///< one sentence
    std::string_view material;  ///< of the palette
    Vec2 size;                  ///< m
    double sill;                ///< m, from the floor to its lower edge
    bool level = false;         ///< lies in floor or ceiling rather than in a wall
};
std::span<const SubAreaKind> sub_area_kinds();
const SubAreaKind* find_sub_area_kind(std::string_view kind);

const SubArea* find_sub_area(const Scene& scene, ObjectId id);

/// One in this face, as near to its middle as it covers no other; made smaller where the face is.
///
/// Returns   no object without a room or such a face.
Added with_sub_area(Scene scene, const SubAreaKind& kind, int face);
/// The same with its middle at a place of the face, in the face's coordinates, kept within it.
Added with_sub_area(Scene scene, const SubAreaKind& kind, int face, double middle);

/// Its middle in the scene; nothing when the id is none of a sub-area.
std::optional<Vec3> place_of_sub_area(const Scene& scene, ObjectId id);
/// Slid over its face as far as the movement points along it; it stops at the face's edges.
Scene with_sub_area_moved(Scene scene, ObjectId id, const Vec3& by);
/// A copy beside it on the same face, where there is room.
Added with_sub_area_copied(Scene scene, ObjectId id);

/// A sub-area of another room, or of this one, put on the face of the same number: shifted by `by` along it,
/// or with its middle at `at` where that is another wall (floor or ceiling for one that lies there); then as
/// near to there as it covers no other. On the first wall when the room has no such face.
///
/// Needs     a material of the scene.
/// Returns   no object without a room, or when the face is too small.
Added with_sub_area_pasted(Scene scene, SubArea area, const Vec3& by, const std::optional<FacePlace>& at);

/// Brought within its face: moved, then made smaller. Nothing of it stays of a face narrower than 0.05 m.
///
/// Returns   false when nothing stays.
bool fit_into_face(SubArea& area, const Room& room);

}  // namespace hanei
