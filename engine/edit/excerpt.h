/// Some objects of a scene with all that they need, and such objects joined to a scene: what copying,
/// pasting and duplicating are made of.
#pragma once

#include "engine/edit/room_faces.h"
#include "engine/edit/several.h"

namespace hanei {

/// A scene of these objects alone (groups with their members, arrangements with their luminaires), the
/// materials, photometries and control groups they name, and every arrangement and group that is
/// wholly among them. Without a room, unless parts of its faces are chosen: then with the room and those
/// alone on it. Ids are kept.
Scene excerpt(const Scene& scene, std::span<const ObjectId> chosen);

struct AddedSeveral {
    Scene scene;
    ObjectIds objects;  ///< what to choose: groups stand for their members
};

/// The excerpt's objects, moved, as new objects of the scene. Equal materials and photometries and
/// control groups of the same name are used again; names that are taken get the next free number.
///
/// Parts of faces go to the face of the same number, or to `at` (with_sub_area_pasted).
///
/// Needs     an excerpt whose references lead to objects of its own (check_scene); of a room in it
///           nothing is taken but the parts of its faces.
AddedSeveral with_excerpt(Scene scene, const Scene& excerpt, const Vec3& by,
                          const std::optional<FacePlace>& at = std::nullopt);

/// Copies beside the objects: next to them along x, by their own width.
AddedSeveral duplicated(Scene scene, std::span<const ObjectId> chosen);

/// The name itself when no object of the scene has it, else the same with the next free number
/// behind it: "Desk 3" after "Desk 2", "Lamp 2" after "Lamp".
std::string free_name(const Scene& scene, const std::string& name);

}  // namespace hanei
