/// Where the parts of the window lie.
#pragma once

#include "ui/panels/preferences.h"
#include "ui/panels/widget_registry.h"

namespace hanei {

/// Wide windows have lists at the left and fields at the right; in narrow ones both stand in one column
/// at the right, lists above fields, so that letters keep their size and the view its room.
struct WindowLayout {
    ScreenRect left, right, bottom, centre, status;
    bool stacked = false;
};

/// `top` is where the menu bar ends. Panels give way to the view where the window is small for its scale.
WindowLayout lay_out(const Preferences& wished, float width, float height, float top, float scale);

}  // namespace hanei
