/// The arrows, squares and rings about what is chosen, and the lines it catches at.
#pragma once

#include "ui/panels/object_drag.h"
#include "ui/panels/pane.h"
#include "ui/panels/widget_registry.h"

namespace hanei {

struct HandleSight {
    const Pane& pane;
    Vec3 place{0.0};     ///< of what is chosen
    bool tilts = false;  ///< it is a luminaire
    double yaw = 0.0;    ///< of that luminaire: the ring of its tilt stands in plane C0
};

/// The handle at a place of the screen.
std::optional<Grip> handle_at(const HandleSight& sight, ImVec2 at);

/// Draws those that can be taken; during a drag the one that is held. Notes "handle.x", "handle.plane",
/// "handle.rotate", ... when the registry is given.
void draw_handles(const HandleSight& sight, std::optional<Grip> held, std::optional<Grip> lit, WidgetRegistry* widgets);

/// Thin lines to what the drag has caught at, with their distances, and how far it has gone.
void draw_guides(const Pane& pane, const ObjectDrag& drag);

}  // namespace hanei
