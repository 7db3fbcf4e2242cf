/// A closed solid of any shape cut into convex ones.
#pragma once

#include "engine/base/vector.h"

#include <vector>

namespace hanei {

/// Part of a solid. Its faces run counter-clockwise seen from outside, as the solid's own do; where it
/// was cut off its neighbours they are no face of the solid.
struct ConvexCell {
    std::vector<Vec3> vertices;
    std::vector<std::vector<int>> faces;
    std::vector<int> surface;  ///< numbers of the solid's faces that lie on it, ascending
};

/// The solid as convex cells that touch but do not overlap; one cell, the solid itself, when it is
/// convex. Space is parted by the planes of faces until no face is left inside a part (binary space
/// partition, Fuchs, Kedem and Naylor 1980); parts around which the solid winds are kept.
///
/// Needs     a closed solid, faces planar and simple, counter-clockwise seen from outside (check_solid).
/// Returns   empty when the cells do not fill the solid's volume, or would be more than
///           `most_convex_cells`: then its faces are to stand for it, one by one.
/// Cost      about 10 us a face and cell.
std::vector<ConvexCell> convex_cells(const std::vector<Vec3>& vertices, const std::vector<std::vector<int>>& faces);

inline constexpr std::size_t most_convex_cells = 400;

}  // namespace hanei
