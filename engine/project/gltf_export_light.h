/// A luminaire as other programs know lights: KHR_lights_punctual.
#pragma once

#include "engine/project/json_value.h"
#include "engine/scene/scene.h"

namespace hanei {

/// A light of the luminaire's luminous flux as it burns, dimmed and maintained: a point of the same
/// intensity all around; or, when less than a twentieth goes upward, a spot of the half space below it,
///
///     I = I0 cos^2 g,  flux = 2 pi / 3 I0.
///
/// What EXT_lights_ies says more exactly (ies_profile.h): this is for programs that do not know it.
JsonValue punctual_light(const Luminaire& luminaire, const Scene& scene);

/// How much of its full output it sends, dimmed and maintained.
double burning_share(const Luminaire& luminaire, const Scene& scene);

}  // namespace hanei
