/// Luminous intensity and flux from a photometric table.
#pragma once

#include "engine/base/vector.h"
#include "engine/scene/photometry.h"

namespace hanei {

// Every function here needs a table that hangs together: as many candela as horizontal times vertical
// angles, both lists increasing, at least two vertical angles and one horizontal. What the readers of
// luminaire files give does.

/// The file's two angles of a direction, before its symmetry is applied.
///
///     C:  e = (sin g cos C, sin g sin C, -cos g)          horizontal C in [0, 360), vertical g
///     B:  e = (cos H sin V, -sin H, -cos H cos V)         planes share the horizontal y axis
///     A:  e = (cos Y cos X, -cos Y sin X, sin Y)          planes share the vertical z axis
///
/// in the luminaire's frame: x plane 0, y plane 90, nadir -z (frames and signs: IES LM-63-2002,
/// clause 3; angles run counter-clockwise in type C, clockwise in A and B).
struct PhotometricAngles {
    double horizontal_deg = 0.0;
    double vertical_deg = 0.0;
};
PhotometricAngles photometric_angles(PhotometricType type, const Vec3& direction);
Vec3 photometric_direction(PhotometricType type, const PhotometricAngles& angles);

/// A direction in the luminaire's frame as the file's own planes count it: turned back by
/// Photometry::quarter_turns.
Vec3 in_file_frame(const Photometry& photometry, const Vec3& direction);

/// Intensity towards a unit direction in the luminaire's frame. Bilinear in the file's two angles, its
/// symmetry applied; 0 outside the vertical range; the last plane is joined to the first.
///
/// Weak when the direction is a pole of the type's angles and the file's planes disagree there: the
///           planes meet at the pole but their figures need not.
/// Cost      two arc tangents and two binary searches; no allocation; any thread.
LuminousIntensity intensity(const Photometry& photometry, const Vec3& direction);

/// Exact integral of the bilinear interpolant over the sphere.
LuminousFlux luminous_flux(const Photometry& photometry);

/// The part of luminous_flux that goes below the horizontal.
LuminousFlux downward_flux(const Photometry& photometry);

/// The other flux in use: the mean of a zone's four corners times the zone's exact solid angle, as
/// North American test reports print. Differs from luminous_flux by 0.1 % on fine tables, more on coarse.
LuminousFlux zone_average_flux(const Photometry& photometry);

/// Greatest intensity of the table.
LuminousIntensity peak_intensity(const Photometry& photometry);

/// Where the table is greatest; the first place in the file's order.
PhotometricAngles peak_angles(const Photometry& photometry);

/// What the lamp's flux becomes when the luminaire is tilted (LM-63 TILT), `tilt` from the way it was
/// measured, rad: linear between the file's angles, the last one's beyond them. 1 without factors,
/// and for a lamp that stays horizontal (geometry 2).
double lamp_tilt_factor(const Photometry& photometry, double tilt);

/// The same luminaire with another of its lamp sets: intensities, lumens and watts are in proportion.
///
/// Needs     `set` one of photometry.lamp_sets; both sets of known flux, else intensities stay.
Photometry with_lamp_set(Photometry photometry, std::size_t set);

}  // namespace hanei
