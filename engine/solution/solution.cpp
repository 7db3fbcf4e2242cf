#include "engine/solution/solution.h"

#include "engine/scene/grid_spacing.h"

#include <algorithm>

namespace hanei {

GridFigures figures_of(const GridResult& grid) {
    GridFigures figures;
    double sum = 0.0;
    for (const PointResult& point : grid.points) {
        if (point.value.inside_solid) continue;
        const double lux = point.value.total().value;
        figures.min = figures.points == 0 ? lux : std::min(figures.min, lux);
        figures.max = std::max(figures.max, lux);
        figures.largest_error = std::max(figures.largest_error, point.value.error.total());
        sum += lux;
        ++figures.points;
    }
    if (figures.points > 0) figures.mean = sum / figures.points;
    if (figures.mean > 0.0) figures.uniformity = figures.min / figures.mean;
    return figures;
}

GridResult layout_of(const CalculationGrid& grid) {
    const auto cells = [&](const Vec3& side) { return static_cast<int>(grid_cells(glm::length(side), grid.spacing)); };
    GridResult layout{.grid = grid.id, .columns = cells(grid.along), .rows = cells(grid.across), .points = {}};
    const Vec3 normal = glm::normalize(glm::cross(grid.along, grid.across));
    layout.points.reserve(static_cast<std::size_t>(layout.columns) * static_cast<std::size_t>(layout.rows));
    for (int row = 0; row < layout.rows; ++row) {
        for (int column = 0; column < layout.columns; ++column) {
            PointResult point;
            point.point = grid.id;
            point.position = grid.corner + grid.along * ((column + 0.5) / layout.columns) +
                             grid.across * ((row + 0.5) / layout.rows);
            point.normal = normal;
            layout.points.push_back(point);
        }
    }
    return layout;
}

double mean_illuminance(const Solution& solution) {
    double flux = 0.0, area = 0.0;
    for (std::size_t p = 0; p < solution.mesh->patches.size(); ++p) {
        area += solution.mesh->patches[p].area;
        flux += solution.mesh->patches[p].area * (solution.patch_direct[p] + solution.patch_interreflected[p]);
    }
    return flux / area;
}

}  // namespace hanei
