/// The light of a solution as colours at vertices, for files of other programs.
#pragma once

#include "engine/project/gltf_export.h"
#include "ui/view/view_options.h"

namespace hanei {

/// Cells of the display mesh as triangles, the objects in the order of the scene, coloured as a picture
/// of these options shows them: part, scale, steps, range, exposure.
///
/// Needs     a solution with a display mesh.
LitPicture lit_picture(const Solution& solution, const ViewOptions& look);

}  // namespace hanei
