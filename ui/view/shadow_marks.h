/// Classes of patches and outlines of shadows as they are drawn. Private to the room.
#pragma once

#include "ui/view/class_colours.h"
#include "ui/view/marks.h"

namespace hanei {

/// Patches as triangles; of hatched ones the colour's alpha is 0.
std::vector<SolidVertex> class_marks(const Solution& solution, ObjectId of);

/// Umbrae as lines, penumbrae as dashes, each over a wider pale line that sets it off any ground.
/// `of` names a luminaire, else all of them.
std::vector<LineMark> shadow_lines(const Solution& solution, ObjectId of);

}  // namespace hanei
