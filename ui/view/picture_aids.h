/// What helps to read a drawing on paper: the scale bar, and which way the axes run.
#pragma once

#include "ui/view/canvas.h"
#include "ui/view/offscreen.h"

namespace hanei {

/// In the lower corners of the room's part of the sheet, as the request wishes: the bar at the left, of
/// pictures to scale that are annotated; the axes at the right. `scale` enlarges the lettering.
void letter_aids(Canvas& canvas, const PictureRequest& request, int left, int top, PixelSize view, double scale);

}  // namespace hanei
