/// The way from one camera to another, so that an eye can follow where it is taken.
#pragma once

#include "ui/view/camera.h"

namespace hanei {

/// Whether there is a way: not to or from a mirrored picture, nor from a camera without direction.
bool can_glide(const Camera& from, const Camera& to);

/// Turns about the target by the shorter way, never over the pole, while what the picture covers grows or
/// shrinks evenly. Between perspective and parallel projection the lens grows ever longer: no jump at the end.
///
/// Needs     can_glide(from, to); share 0 to 1.
/// Returns   exactly `to` at 1; what is left out of the picture is that of `to` all the way.
Camera between(const Camera& from, const Camera& to, double share);

}  // namespace hanei
