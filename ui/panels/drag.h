/// Where a dragged object goes: rays of the mouse against planes and axes of the room.
#pragma once

#include "ui/view/camera.h"

#include <optional>

namespace hanei {

enum class Axis { x, y, z };
Vec3 direction_of(Axis axis);

/// Where the ray meets the horizontal plane of this height.
///
/// Returns   nothing when the ray runs within 3 degrees of the horizon, away from the plane, or
///           meets it farther than `reach`: there a pixel would move the object by metres.
std::optional<Vec3> on_horizontal_plane(const Ray& ray, double height, double reach);

/// The place on the line through `origin` along `axis` that is nearest to the ray, as a distance
/// from `origin`. Empty when the ray runs along the axis (within 3 degrees).
std::optional<double> along_axis(const Ray& ray, const Vec3& origin, Axis axis);

/// The nearest multiples of the raster in x and y (and z); raster 0 leaves it as it is.
double snapped(double value, double raster);

}  // namespace hanei
