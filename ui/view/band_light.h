/// The colour of the light and of the surfaces of a solution, for pictures like photographs.
///
/// A solution keeps the colour of all light together. A part of it is shown in the colour of the whole.
#pragma once

#include "ui/view/cell_field.h"

#include <vector>

namespace hanei {

/// Reflectance in the three bands (colour.h) of every patch.
std::vector<Vec3> patch_colours(const Solution& solution);

/// The bands of the illuminances `lux` at the corners of a cell: one row a band, one column a corner,
/// completed like the corners.
///
/// Returns   three times the same where the light is neutral.
std::array<std::array<double, 4>, 3> bands_at_corners(const DisplayMesh& display, const DisplayCell& cell,
                                                      const std::array<double, 4>& lux);

/// The bands of an illuminance at bilinear coordinates of a cell.
///
/// Returns   bands whose luminance is `lux`; where the light is neutral each is `lux`.
Vec3 bands_at(const DisplayMesh& display, const DisplayCell& cell, const Vec2& at, double lux);

}  // namespace hanei
