/// The frames the window is divided into.
#pragma once

#include "ui/panels/widget_registry.h"

#include <cstddef>
#include <string>
#include <string_view>

namespace hanei {

/// Which side of a panel can be dragged.
enum class Edge { none, left, right, top };

/// Opens a panel that fills the rectangle; its content goes between begin and end.
void begin_panel(const char* name, const ScreenRect& area, bool padded = true);
void end_panel();

/// Within a panel: its movable edge. Changes `size` (at scale 1, kept within low and high).
void movable_edge(Edge edge, const ScreenRect& area, float& size, float low, float high);

/// A title in strong letters with a quiet word behind it.
void headline(std::string_view text, std::string_view quiet);

/// A tab bar whose tabs keep their words. They move closer where they have too little room side by side;
/// where that is not enough the bar is rolled by its arrows, and its list names all of them.
bool begin_tabs(const char* name);
void end_tabs();

/// Within a panel: content that needs this width (at scale 1). Where there is less it is rolled sideways.
void begin_wide(const char* name, float least_width);
void end_wide();

/// A tab of the bar opened by begin_tabs(), noted as "tab.LABEL"; a count above 0 stands behind the label. `to_front`:
/// it is chosen in this frame.
bool begin_tab(const char* label, WidgetRegistry& widgets, std::size_t count = 0, bool to_front = false);

}  // namespace hanei
