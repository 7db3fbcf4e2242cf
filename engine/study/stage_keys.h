/// What each stage is made from: the scene with everything taken out that the stage does not read.
#pragma once

#include "engine/scene/scene.h"

namespace hanei {

/// Shapes and places of everything that receives light: what form factors depend on. Materials,
/// names, luminaires, grids and views are taken out.
Scene shapes_of(const Scene& scene);

/// The shapes with their materials' ids (not the reflectances): what the mesh depends on.
Scene surfaces_of(const Scene& scene);

/// The luminaire at full output: what its direct light depends on. Name, group, dimming are taken out.
Luminaire light_of(const Luminaire& luminaire);

}  // namespace hanei
