/// One face cut into convex cells of one material that light can reach.
#pragma once

#include "engine/mesh/mesh.h"

#include <span>
#include <vector>

namespace hanei {

struct Cell {
    Polygon outline;  ///< convex, counter-clockwise seen from the lit side
    ObjectId material;
};

/// A line in the plane of a face that no patch may cross.
struct Crease {
    Vec3 from{0.0};
    Vec3 to{0.0};
};

/// The paper's equation 5, the number of patches along a side: floor(side / wished + 0.5), but at
/// least 1 (as printed it divides by zero for a side under half the wished width).
int patches_along(double side, double wished);

/// The lines of a grid between two places, `low` and `high` among them, ascending. Crowded lines lie at
/// t^q from either end for t in equal steps (Atkinson's graded mesh).
std::vector<double> grid_lines(double low, double high, double wished, Grading grading);

/// Cells of a face, row by row along Face::along. The grid lies on the smallest rectangle around
/// the face in that direction; cells are cut at the outline, by `covers` (convex polygons in the
/// plane of the face), along creases and where sub-areas begin. Slivers thinner than `thickness` are dropped.
///
/// Weak when a cell is cut: its pieces' corners may lie on edges of their neighbours (T-junctions).
std::vector<Cell> cells_of(const Face& face, std::span<const Polygon> covers, std::span<const Crease> creases,
                           double max_patch, Grading grading, double thickness);

}  // namespace hanei
