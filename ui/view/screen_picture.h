#pragma once

#include "ui/view/image.h"
#include "ui/view/picture_size.h"

namespace hanei {

/// What stands in a rectangle of the framebuffer that is bound, opaque, rows from the top. `left` and `top`
/// are counted from the window's top left corner; what lies outside is cut away.
/// Needs     a current context. Returns an image without pixels when nothing is left of the rectangle.
Image picture_of_screen(PixelSize window, int left, int top, PixelSize wished);

}  // namespace hanei
