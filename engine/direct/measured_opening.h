/// The surfaces of a measured opening that a receiver sees.
#pragma once

#include "engine/base/vector.h"
#include "engine/scene/opening_shape.h"

#include <vector>

namespace hanei {

/// Convex polygons that together cover exactly what the eye sees of the solid's luminous surface, none
/// twice, in the luminaire's frame as the eye is. Light from a surface whose luminance depends on the
/// direction alone is a matter of what solid angle it fills, so that the round ones may be cut flat:
///
///     box        the faces before which the eye is, the sides as far up as they are luminous
///     cylinder   the rectangle between the two lines where sight touches the mantle, and of either end
///                the part beyond it (an end that is seen) or before it (one that is not)
///     ellipsoid  the disc within the ellipse where sight touches it
///
/// Arcs are polygons of 32 corners a turn with the area of the round, so that from afar the projected
/// area is OpeningSolid's.
///
/// Returns   nothing inside the solid: no light there.
void seen_faces(const OpeningSolid& solid, const Vec3& eye, std::vector<Polygon>& faces);

}  // namespace hanei
