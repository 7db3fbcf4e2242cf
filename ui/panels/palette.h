/// The colours of the window, light and dark.
#pragma once

#include "ui/panels/preferences.h"

#include <imgui.h>

namespace hanei::style {

/// Every letter reads with a contrast of 4.5 : 1 or more (WCAG 2.1, AA) on every ground it stands on;
/// marks and lines with 3 : 1. No colour says anything alone: a shape or a word goes with it.
struct Palette {
    // Letters.
    ImU32 text, quiet_text;           ///< quiet: units, captions, what is stale
    ImU32 accent;                     ///< lamp light: what is lit and selected
    ImU32 second;                     ///< beside the accent: of two curves the dashed one
    ImU32 good, warning, error;       ///< each stands beside a mark of its own shape
    ImU32 axis_x, axis_y, axis_z;     ///< with the axis' letter
    ImU32 furniture, reading, sight;  ///< marks of objects in lists: bodies, points and grids, views

    // Grounds.
    ImU32 ground;  ///< behind everything
    ImU32 panel, popup, field, field_hovered, field_active;
    ImU32 card;                           ///< of texts over a picture: seen through a little
    ImU32 chosen, chosen_hovered;         ///< laid over a panel
    ImU32 row;                            ///< every second row of a table, laid over a panel
    ImU32 line, border, plot, plot_axis;  ///< hairlines
    ImU32 shade;                          ///< under lines over a picture
    ImU32 dimmed;                         ///< over everything behind a dialog
};

const Palette& palette(Theme theme);

/// The contrast of two opaque colours, 1 to 21 (WCAG 2.1); `top` may be seen through.
double contrast(ImU32 top, ImU32 ground);

/// `top` laid over an opaque ground by its opacity.
ImU32 laid_over(ImU32 top, ImU32 ground);

}  // namespace hanei::style
