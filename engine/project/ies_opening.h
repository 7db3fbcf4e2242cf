/// The luminous opening of an LM-63 file: three lengths whose signs say the shape.
#pragma once

#include "engine/scene/photometry.h"

#include <optional>

namespace hanei {

/// Width (along plane 90), length (along plane 0) and height in metres, signs as in the file.
struct IesDimensions {
    double width = 0.0;
    double length = 0.0;
    double height = 0.0;
};

/// The codes of every version are taken in every version; only where one code means two shapes
/// (- + -, + - -, - 0 -) `until_1995` decides.
/// Returns   empty for a combination of signs that stands for no shape in any version.
std::optional<MeasuredOpeningSize> ies_opening(const IesDimensions& dimensions, bool until_1995);

}  // namespace hanei
