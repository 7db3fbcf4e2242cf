/// How many points a calculation grid has, and how far apart they should be.
#pragma once

#include "engine/scene/scene.h"

namespace hanei {

inline constexpr double most_grid_points = 1e6;  ///< more cannot be computed

/// Cells on one side of a grid, as many as come nearest to the wished spacing: one at least.
double grid_cells(double side, double spacing);

/// A cell's centre each: along and across as many cells as come nearest to the wished spacing.
/// Needs     a spacing above 0.
double grid_points(const CalculationGrid& grid);

/// m, the greatest spacing that EN 12464-1 (equation 1) allows on a grid of these sides:
/// 0.2 m * 5^(log10 d), d the longer side in metres. Its cap of 10 m is left out, which keeps the
/// points of ground kilometres wide few.
double standard_spacing(const CalculationGrid& grid);

/// m, the least with which the grid has no more than most_grid_points.
double least_spacing(const CalculationGrid& grid);

}  // namespace hanei
