/// Every tolerance of the house, with its unit, its size in a room, and what breaks without it.
/// All are relative: multiply by the length in question, or by the diameter of the scene.
#pragma once

namespace hanei::tolerance {

/// Two places closer than this times the scene's diameter are one place. A 10 m room: 1e-8 m, a
/// hundredth of the wavelength of light; a thousand times the rounding of a coordinate at 10 m.
/// Larger would merge real millimetre gaps in a kilometre-sized scene; smaller would see gaps
/// between a desk's foot and the floor that only rounding made.
inline constexpr double same_place = 1e-9;

/// A free receiver closer to the plane or an edge of a polygon than this times the distance of its
/// farthest corner lies on it: 1e-11 m in a 10 m room, a thousand times the rounding of a vector
/// between two places of it. Larger would take a point a nanometre beside a luminous opening for
/// one in it; smaller would make the light at a wall's foot a matter of rounding.
inline constexpr double touching = 1e-12;

/// A polygon is planar when no vertex leaves its plane by more than this times its diameter.
/// 1e-6 of a 5 m wall is 5 um: coordinates typed to the tenth of a millimetre pass after rotation.
inline constexpr double planar = 1e-6;

/// A polygon with less area than this times the square of its diameter has no area: its normal
/// would be rounding noise.
inline constexpr double no_area = 1e-12;

/// Unit vectors whose cosine differs from 1 by less than this point the same way: 1e-10 is an
/// angle of 1.4e-5 rad, 0.07 mm over 5 m.
inline constexpr double parallel = 1e-10;

}  // namespace hanei::tolerance
