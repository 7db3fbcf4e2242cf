/// From the axes of a photometric frame to the angles of a luminaire: the inverse of placement().
#pragma once

#include "engine/scene/scene.h"

namespace hanei {

/// Turns the luminaire so that its nadir (-z) points along `nadir` and its plane C0 (x) along `c0`.
///
/// Needs     vectors that are not parallel; c0 is made square to the nadir. A luminaire whose C0
///           is vertical could be turned in many ways: its yaw is then 0.
void aim(Luminaire& luminaire, const Vec3& nadir, const Vec3& c0);

/// Any direction square to `nadir`, +x where that is possible.
Vec3 any_c0(const Vec3& nadir);

}  // namespace hanei
