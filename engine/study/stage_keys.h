/// What each stage is made from: the scene with everything taken out that the stage does not read.
#pragma once

#include "engine/scene/scene.h"

namespace hanei {

/// What the mesh depends on: shapes and places of everything that receives light, with the ids of
/// their materials (not the reflectances), and the opaque luminaires, which cover what they lie on.
Scene surfaces_of(const Scene& scene);

/// The luminaire at full output: what its direct light depends on. Name, group, dimming and colour are taken out.
Luminaire light_of(const Luminaire& luminaire);

/// The photometry it shines by; null when it has none.
const Photometry* measured_of(const Scene& scene, const Luminaire& luminaire);

}  // namespace hanei
