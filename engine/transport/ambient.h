/// An estimate of interreflection that needs no form factor: for the picture shown before there is one.
#pragma once

#include <span>

namespace hanei {

/// lx, the interreflected light of a room in which every place sees the same mix of surfaces (the
/// integrating sphere; the ambient term of progressive refinement, Cohen et al. 1988):
///
///     E = mean of (own + reflectance x direct) / (1 - mean of reflectance),     means by area
///
/// the same everywhere, and the exitance of a surface own + reflectance x (direct + E). In furnished
/// offices it was 3 to 7 % above the mean of the solution.
///
/// Needs     one value a patch or node in each span.
/// Returns   0 without area, and where the mean reflectance is 1: there is no such light.
/// Weak when the room has large openings, which it takes for closed, or parts that hardly see the others.
double ambient_illuminance(std::span<const double> areas, std::span<const double> reflectance,
                           std::span<const double> own_exitance, std::span<const double> direct);

}  // namespace hanei
