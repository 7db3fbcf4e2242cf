/// Where luminaires hang that are dropped on the view.
#pragma once

#include "engine/scene/scene.h"
#include "ui/view/camera.h"

#include <optional>

namespace hanei {

/// The place in the plan below which the ray first meets something: what the pointer shows. Kept
/// off walls and within the room; the middle of the room where it meets nothing.
///
/// Needs     raster >= 0, in metres; 0 is none.
Vec2 place_in_plan(const Scene& scene, const std::optional<Ray>& ray, double raster);

}  // namespace hanei
