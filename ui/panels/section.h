/// A section plane through the room, laid across an axis and moved along it.
#pragma once

#include "ui/panels/drag.h"
#include "ui/panels/widget_registry.h"
#include "ui/view/camera.h"

namespace hanei {

/// The plane across this axis that opens the room towards the eye: through its middle, the level one
/// 1.2 m above the floor where the room is high enough, as plans are cut.
Cut section_across(Axis axis, const Camera& camera, const Bounds& bounds);

/// A level one where there is none; none where there is one.
void toggle_section(Camera& camera, const Bounds& bounds);

/// The same plane with the other side left out.
Cut flipped(const Cut& cut);

/// Middle of the room on the plane: where its handle is.
Vec3 handle_of(const Cut& cut, const Bounds& bounds);

/// The plane moved to where the ray passes its normal through the handle nearest, kept within the
/// bounds; as it was when the ray runs along the normal. raster 0 is none.
Cut moved_to(const Cut& cut, const Ray& ray, const Bounds& bounds, double raster);

/// Of perspective cameras, where they are edited: degrees.
constexpr double least_field_of_view = 20.0, greatest_field_of_view = 100.0;

/// Rows of an open popup: the field of view, the ceiling, the plane, its axis, side and place. Widgets are
/// noted as "NAME.on", "NAME.place", ... Returns whether the camera was changed.
bool section_rows(Camera& camera, const Bounds& bounds, const std::string& name, WidgetRegistry& widgets);

}  // namespace hanei
