/// Photometries of the lights of KHR_lights_punctual, which have no luminous opening.
#pragma once

#include "engine/scene/photometry.h"

namespace hanei {

/// The same intensity all around, candela.
Photometry point_light(double candela);

/// The cone of a spot light about the nadir:
///
///     I(g) = I0 clamp((cos g - cos outer) / (cos inner - cos outer), 0, 1)^2
///
/// from the extension, without its guard against cones that are nearly equal: an edge sharper than
/// a millionth of a radian is given that width.
///
/// Needs     0 <= inner <= outer, outer from narrowest_cone to a quarter turn; radians.
/// Returns   a table whose interpolant misses the curve by at most 1e-4 of I0.
Photometry spot_light(double candela, double inner, double outer);

inline constexpr double narrowest_cone = 1e-3;  ///< rad: a spot of 1 mm at 1 m

}  // namespace hanei
