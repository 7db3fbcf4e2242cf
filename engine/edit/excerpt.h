/// Some objects of a scene with all that they need, and such objects joined to a scene: what copying,
/// pasting and duplicating are made of.
#pragma once

#include "engine/edit/several.h"

namespace hanei {

/// A scene of these objects alone (groups with their members, arrangements with their luminaires), the
/// materials, photometries and control groups they name, and every arrangement and group that is
/// wholly among them. Without a room; ids are kept.
Scene excerpt(const Scene& scene, std::span<const ObjectId> chosen);

struct AddedSeveral {
    Scene scene;
    ObjectIds objects;  ///< what to choose: groups stand for their members
};

/// The excerpt's objects, moved, as new objects of the scene. Equal materials and photometries and
/// control groups of the same name are used again; names that are taken get the next free number.
///
/// Needs     an excerpt whose references lead to objects of its own (check_scene); of a room in it
///           nothing is taken.
AddedSeveral with_excerpt(Scene scene, const Scene& excerpt, const Vec3& by);

/// Copies beside the objects: next to them along x, by their own width.
AddedSeveral duplicated(Scene scene, std::span<const ObjectId> chosen);

/// The name itself when no object of the scene has it, else the same with the next free number
/// behind it: "Desk 3" after "Desk 2", "Lamp 2" after "Lamp".
std::string free_name(const Scene& scene, const std::string& name);

}  // namespace hanei
