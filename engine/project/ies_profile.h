/// The light of a luminaire as an LM-63 file, for programs that know lights by such files.
#pragma once

#include "engine/scene/scene.h"

#include <string>

namespace hanei {

/// What the luminaire sends at full output, as from a point, in its own frame (IntensityOf): LM-63-2002, type C,
/// absolute, its opening stated where the format has a word for it. A table of type C keeps its own angles, so
/// that read again it is the same to a ten-millionth of its peak; of symmetries only those of planes from 0 on
/// are used, which every reader knows. Anything else is sampled: every degree from the nadir, every 2.5 degrees
/// around it from a table of another type, every 5 from a smooth curve.
std::string ies_profile(const Scene& scene, const Luminaire& luminaire);

}  // namespace hanei
