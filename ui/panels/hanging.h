/// Where luminaires hang that are dropped on the view, and how several of them hang side by side.
#pragma once

#include "ui/panels/edit.h"
#include "ui/view/camera.h"

#include <optional>
#include <vector>

namespace hanei {

/// The place in the plan below which the ray first meets something: what the pointer shows. Kept
/// off walls and within the room; the middle of the room where it meets nothing.
///
/// Needs     raster >= 0, in metres; 0 is none.
Vec2 place_in_plan(const Scene& scene, const std::optional<Ray>& ray, double raster);

/// Luminaires of these photometries below the ceiling, side by side along x about the place, each
/// as its file measures it, in the colour temperature it states. The last one is the object that was added.
///
/// Needs     at least one photometry.
Added with_measured_luminaires(Scene scene, std::vector<Photometry> photometries, Vec2 place);

}  // namespace hanei
