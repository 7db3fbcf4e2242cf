#include "engine/scene/grid_spacing.h"

#include <algorithm>
#include <cmath>

namespace hanei {

double grid_cells(double side, double spacing) { return std::max(1.0, std::round(side / spacing)); }

double grid_points(const CalculationGrid& grid) {
    return grid_cells(glm::length(grid.along), grid.spacing) * grid_cells(glm::length(grid.across), grid.spacing);
}

double standard_spacing(const CalculationGrid& grid) {
    const double longer = std::max(glm::length(grid.along), glm::length(grid.across));
    return 0.2 * std::pow(5.0, std::log10(std::max(0.1, longer)));
}

double least_spacing(const CalculationGrid& grid) {
    const double along = glm::length(grid.along);
    const double across = glm::length(grid.across);
    // Rounding adds half a cell a side at most: with w the spacing, (a/w + 1/2)(b/w + 1/2) = most_grid_points.
    const double half = 0.25 * (along + across);
    const double rest = most_grid_points - 0.25;
    return (half + std::sqrt(half * half + rest * along * across)) / rest;
}

}  // namespace hanei
