/// The frames the window is divided into.
#pragma once

#include "ui/panels/widget_registry.h"

namespace hanei {

/// Which side of a panel can be dragged.
enum class Edge { none, left, right, top };

/// Opens a panel that fills the rectangle; its content goes between begin and end.
void begin_panel(const char* name, const ScreenRect& area, bool padded = true);
void end_panel();

/// Within a panel: its movable edge. Changes `size` (at scale 1, kept within low and high).
void movable_edge(Edge edge, const ScreenRect& area, float& size, float low, float high);

}  // namespace hanei
