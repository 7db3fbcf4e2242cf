/// Control groups: luminaires that are dimmed together, and the light scenes that preset their dimmers.
#pragma once

#include "engine/edit/edit.h"
#include "engine/scene/dimmers.h"

#include <span>
#include <string>

namespace hanei {

/// The group of this name, made when there is none yet; no group for an empty name.
ObjectId control_group_named(Scene& scene, const std::string& name);

/// How many luminaires the group dims; with the id of nothing: how many have no group.
int members_of(const Scene& scene, ObjectId group);

/// These luminaires in the group; in none for the id of nothing. Ids of other things are passed over.
Scene with_group_of(Scene scene, std::span<const ObjectId> luminaires, ObjectId group);

/// A new group of these luminaires, at full output, named by its number.
Added with_control_group(Scene scene, std::span<const ObjectId> luminaires);

/// The group's dimmer at this level, 0 to 1.
Scene dimmed(Scene scene, ObjectId group, double level);

/// All groups but this one are off; it is on, fully when it was off.
Scene alone(Scene scene, ObjectId group);

/// Null when the id names none.
const LightScene* find_light_scene(const Scene& scene, ObjectId id);

/// The dimmers of all groups as they are.
std::vector<LightScene::Level> present_levels(const Scene& scene);

/// The groups it names dimmed as it says; others stay.
Scene recalled(Scene scene, ObjectId light_scene);
Scene with_levels(Scene scene, std::span<const LightScene::Level> levels);

/// Every group it names stands at its level; false for one that names none.
bool is_recalled(const Scene& scene, const LightScene& light_scene);

/// The light scene takes the dimmers as they are; a new one does, named by its number.
Scene with_stored_levels(Scene scene, ObjectId light_scene);
Added with_light_scene(Scene scene);

}  // namespace hanei
