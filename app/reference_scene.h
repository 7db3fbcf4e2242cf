/// Reference cases through the door that projects go through.
#pragma once

#include "engine/project/reference_case.h"

namespace hanei {

/// The case's points become calculation points of its scene, so that the usual door computes them.
SceneSnapshot scene_with_points(const ReferenceCase& reference);

/// A patch width that cuts the scene's reflecting faces into about `unknowns` patches; 1 m when it has none.
double suitable_patch(const Scene& scene, double unknowns);

}  // namespace hanei
