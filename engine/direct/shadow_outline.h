/// The outlines of umbra and penumbra on a face: the paper's fifth step.
#pragma once

#include "engine/direct/direct.h"
#include "engine/scene/faces.h"

#include <span>
#include <vector>

namespace hanei {

/// Shadows of one luminaire on one face. Loops run counter-clockwise seen from the lit side, holes
/// clockwise; lines are the loops' parts within the face, without what runs along its border.
struct FaceShadows {
    std::vector<Polygon> umbra, penumbra;  ///< loops; the umbra lies in the penumbra
    std::vector<Polygon> umbra_lines, penumbra_lines;
};

/// Cuts every body's penumbra and umbra volume (shadow_volume.h) with the face in three dimensions,
/// so that shadows without end are no trouble, and unites them over the bodies: of lines inside
/// another body's region nothing is left. `covers` (convex polygons in the face's plane, where
/// furniture stands) are taken out.
///
/// Holds     to 1e-9 of the face's diameter. Outside the penumbra every point sees all of the opening
///           above its horizon; inside, some of it is hidden; in the umbra all is.
/// Weak when bodies hide an opening together: the umbra is that of single bodies, and there can be
///           places without light beyond it.
/// Cost      10 us a body near the sight lines.
FaceShadows shadows_on(const Face& face, std::span<const Polygon> covers, const Emitter& emitter,
                       const OccluderSet& occluders);

}  // namespace hanei
