/// What dims and tints a luminaire in the end: its own settings and those of its control group.
#pragma once

#include "engine/scene/scene.h"

namespace hanei {

/// Null when the id names none.
const ControlGroup* find_control_group(const Scene& scene, ObjectId id);

/// The dimming of the luminaire's group; 1 without a group.
double group_dimming_of(const Scene& scene, const Luminaire& luminaire);

/// Share of the luminaire's full output that shines: its own dimming times its group's.
double dimming_of(const Scene& scene, const Luminaire& luminaire);

/// K, of the luminaire's light: its group's where that has one, else its own; 0 is neutral.
double colour_temperature_of(const Scene& scene, const Luminaire& luminaire);

/// Whether anything could shine in it: a luminaire, or a surface with an exitance of its own.
bool holds_light(const Scene& scene);

}  // namespace hanei
