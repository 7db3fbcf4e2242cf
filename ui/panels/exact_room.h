/// The exact picture of a solution: the window's and the command line's one way to it.
#pragma once

#include "ui/view/exact_picture.h"

namespace hanei {

/// The room as exact_picture paints it, with the solution's own luminaires and shadow casters.
/// Needs     a solution with a mesh and a display mesh that holds the part.
/// Returns   null when stopped.
std::shared_ptr<const ExactPicture> exact_room(const SolutionSnapshot& solution, const ExactRequest& request,
                                               const Work& work);

}  // namespace hanei
