/// Luminaires of photometric files hung below the ceiling, side by side.
#pragma once

#include "engine/edit/edit.h"

#include <vector>

namespace hanei {

/// Axis-aligned bounds of the room's plan; those of an office of 6 m x 4 m without a room.
struct PlanBounds {
    Vec2 low{0.0}, high{0.0};
    Vec2 middle() const { return 0.5 * (low + high); }
};
PlanBounds bounds_of_plan(const Scene& scene);

/// Luminaires of these photometries below the ceiling, side by side along x about the place, each
/// as its file measures it, in the colour temperature it states. The last one is the object that was added.
///
/// Needs     at least one photometry.
Added with_measured_luminaires(Scene scene, std::vector<Photometry> photometries, Vec2 place);

}  // namespace hanei
