/// What a luminaire of the scene shines as.
#pragma once

#include "engine/direct/diffuse_source.h"
#include "engine/direct/line_source.h"
#include "engine/direct/measured_source.h"
#include "engine/direct/point_source.h"

#include <variant>

namespace hanei {

using Source = std::variant<PointSource, LineSource, DiffuseSource, MeasuredSource>;

struct MadeSource {
    LuminousFlux flux;  ///< at full output
    Source source;
};

/// Needs     a scene without errors; `luminaire` one of its luminaires.
/// Returns   a dark point for a luminaire without a usable opening or table.
MadeSource make_source(const Scene& scene, const Luminaire& luminaire);

}  // namespace hanei
