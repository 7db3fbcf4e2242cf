/// Turning luminaires so that they shine on a place.
#pragma once

#include "engine/scene/scene.h"

#include <span>

namespace hanei {

/// Where the luminaire shines most, a unit vector in its own frame: the direction about which its
/// intensities crowd. Alike to all sides it is the nadir, or the zenith of one that shines up; an
/// asymmetric one has it near its peak.
///
///     d = sum I(e)^8 e dw,    the nadir where |d| is small against the sum of its parts
Vec3 main_beam(const Scene& scene, const Luminaire& luminaire);

/// The main beam as the luminaire is turned, in the scene.
Vec3 beam_in_scene(const Scene& scene, const Luminaire& luminaire);

/// The luminaire turned so that its main beam meets the target: by yaw and tilt, or by yaw and roll
/// where the beam lies nearer to plane C90, and by all three where these do not reach. Of two ways
/// the one that tilts it less; straight up and down it keeps its yaw.
///
/// Weak when the target is the luminaire's own place: it stays as it is.
Luminaire aimed(const Scene& scene, Luminaire luminaire, const Vec3& target);

/// The same of several; ids of other things are passed over.
Scene aimed(Scene scene, std::span<const ObjectId> luminaires, const Vec3& target);

}  // namespace hanei
