/// A small picture of a piece of the library, drawn from its parts.
#pragma once

#include "engine/edit/furniture_library.h"

#include <imgui.h>

namespace hanei {

/// Seen from its front right, above, as large as fits into the rectangle.
///
/// Cost      the faces are worked out once a kind; then a filled polygon a face.
void draw_furniture(const FurnitureKind& kind, ImVec2 low, ImVec2 high);

}  // namespace hanei
