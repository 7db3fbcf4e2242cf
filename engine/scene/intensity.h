/// Luminous intensity and flux from a photometric table.
#pragma once

#include "engine/base/vector.h"
#include "engine/scene/photometry.h"

namespace hanei {

/// Intensity towards a unit direction in the luminaire's frame (x plane 0, y plane 90, nadir -z).
/// Bilinear in the file's two angles, its symmetry applied; 0 outside the vertical range.
/// Frames of types A, B and C: shared photometric convention, IES LM-63-2002 clause 3.
LuminousIntensity intensity(const Photometry& photometry, const Vec3& direction);

/// Exact integral of the bilinear interpolant over the sphere.
LuminousFlux luminous_flux(const Photometry& photometry);

/// Greatest intensity of the table.
LuminousIntensity peak_intensity(const Photometry& photometry);

}  // namespace hanei
