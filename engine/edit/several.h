/// Changes to several objects at once: a scene in and a scene out.
///
/// An arrangement whose luminaires are all moved together moves along with them; a luminaire that is
/// moved without the others leaves its arrangement.
#pragma once

#include "engine/edit/edit.h"
#include "engine/scene/faces.h"

#include <span>
#include <vector>

namespace hanei {

using ObjectIds = std::vector<ObjectId>;

/// The objects themselves: groups are replaced by their members, arrangements by their luminaires;
/// each once, in order; without what the scene does not hold.
ObjectIds objects_of(const Scene& scene, std::span<const ObjectId> chosen);

/// The group that the object is a member of; the id of nothing when it is in none.
ObjectId group_of(const Scene& scene, ObjectId id);

/// All objects of the kinds of these: of one luminaire all luminaires.
ObjectIds same_kind(const Scene& scene, std::span<const ObjectId> chosen);

/// Everything that has a place in the room, groups for their members.
ObjectIds all_objects(const Scene& scene);

/// Axis-aligned bounds of the objects; empty when none of them has a place.
std::optional<Bounds> bounds_of_objects(const Scene& scene, std::span<const ObjectId> chosen);

/// One object: its place. Several: the middle of their bounds. Empty when none can be moved.
std::optional<Vec3> middle_of(const Scene& scene, std::span<const ObjectId> chosen);

Scene moved(Scene scene, std::span<const ObjectId> chosen, const Vec3& by);

/// About the vertical through `pivot`, counter-clockwise seen from above (rad). Luminaires and
/// furniture turn themselves too; grids and surfaces turn their sides, points only move.
Scene turned(Scene scene, std::span<const ObjectId> chosen, const Vec3& pivot, double angle);

/// Without those that can be removed (can_remove).
Scene removed(Scene scene, std::span<const ObjectId> chosen);
bool can_remove(const Scene& scene, std::span<const ObjectId> chosen);

/// "luminaire", "4 luminaires", "group", "5 objects".
std::string words_for(const Scene& scene, std::span<const ObjectId> chosen);

}  // namespace hanei
