/// The light within one cell of the picture: bilinear between its four corners (the paper's
/// equation 6), by inverting the bilinear map of the corners' places.
#pragma once

#include "ui/view/view_options.h"

#include <array>

namespace hanei {

/// A cell laid flat: its corners in two dimensions, the first at 0. A triangle is completed to a
/// parallelogram, on which bilinear is linear.
struct CellFrame {
    Vec3 origin{0.0};
    Vec3 along{1.0, 0.0, 0.0};
    Vec3 across{0.0, 1.0, 0.0};
    Vec3 normal{0.0, 0.0, 1.0};
    std::array<Vec2, 4> corner{};
    bool triangle = false;

    Vec2 flat(const Vec3& place) const { return {glm::dot(place - origin, along), glm::dot(place - origin, across)}; }
};

/// Needs     a solution with a mesh and a display mesh.
CellFrame frame_of(const Solution& solution, const DisplayCell& cell);

/// The four corner values of a part, completed like the corners.
std::array<double, 4> corner_values(const DisplayMesh& display, const DisplayCell& cell, LightPart part);

/// Bilinear coordinates of a place in the cell's plane: (0,0) at the first corner, (1,1) at the
/// third. Outside the cell they continue the map.
Vec2 bilinear_coordinates(const CellFrame& frame, const Vec2& flat);
double bilinear(const std::array<double, 4>& values, const Vec2& at);

/// Inside the cell, its border included.
bool contains(const CellFrame& frame, const Vec2& flat);

}  // namespace hanei
