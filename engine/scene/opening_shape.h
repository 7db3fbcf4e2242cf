/// The luminous opening a photometric file states, as surfaces about the luminaire's place.
#pragma once

#include "engine/base/vector.h"
#include "engine/scene/photometry.h"

#include <array>

namespace hanei {

/// A box, cylinder or ellipsoid, centred on the luminaire's place. What of it is luminous: of a box
/// the bottom, the top, and of every side its own height from the bottom up; of the others the whole
/// surface. (A top that the file sends nothing upward from stays dark by itself.)
struct OpeningSolid {
    enum class Kind { box, cylinder, ellipsoid };
    Kind kind = Kind::box;
    Vec3 half{0.0};                 ///< half the extents along plane 0, plane 90 and the vertical, m
    int axis = 2;                   ///< of a cylinder: 0 plane 0, 1 plane 90, 2 vertical
    std::array<double, 4> sides{};  ///< m, of a box: heights of the sides at planes 0, 90, 180, 270

    /// Projected luminous area towards a unit direction, m2: what the file's intensity is shared by.
    ///
    ///     box       |e_z| l w + |e_x| w h(0 or 180) + |e_y| l h(90 or 270)
    ///     cylinder  |e_axis| pi a b + 2 L sqrt(a^2 e_b^2 + b^2 e_a^2)
    ///     ellipsoid pi sqrt((b c e_x)^2 + (a c e_y)^2 + (a b e_z)^2)
    double projected_area(const Vec3& direction) const;
    /// The same along the three axes, of each the greater of the two ways.
    Vec3 areas_along_axes() const;
};

/// True for shapes with height; a box without height is its rectangle, a cylinder its round, and a
/// point no opening at all.
bool is_solid(const MeasuredOpeningSize& size);

/// Needs     is_solid(size). Extents of 0 become a hundredth of the greatest.
OpeningSolid solid_opening(const MeasuredOpeningSize& size);

/// The opening as a flat polygon facing down: a rectangle; rounds as a 32-sided polygon of their
/// circle's or ellipse's area; an upright disc facing plane 0. Lamps without width get a hundredth of
/// their length. Of a solid what it covers seen from below. Empty for a point.
Polygon flat_opening(const MeasuredOpeningSize& size);

}  // namespace hanei
