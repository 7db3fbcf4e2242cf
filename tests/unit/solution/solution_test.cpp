#include "engine/solution/solution.h"

#include <gtest/gtest.h>

namespace hanei {
namespace {

TEST(Grid, points_lie_at_the_centres_of_its_cells) {
    CalculationGrid grid;
    grid.corner = {1.0, 2.0, 0.8};
    grid.along = {2.0, 0.0, 0.0};
    grid.across = {0.0, 1.0, 0.0};
    grid.spacing = 0.5;
    const GridResult layout = layout_of(grid);
    ASSERT_EQ(layout.columns, 4);
    ASSERT_EQ(layout.rows, 2);
    ASSERT_EQ(layout.points.size(), 8u);
    EXPECT_EQ(layout.points.front().position, Vec3(1.25, 2.25, 0.8));
    EXPECT_EQ(layout.points.back().position, Vec3(2.75, 2.75, 0.8));
    EXPECT_EQ(layout.points.front().normal, Vec3(0.0, 0.0, 1.0));
}

TEST(Grid, a_side_shorter_than_the_spacing_has_one_point) {
    CalculationGrid grid;
    grid.spacing = 10.0;
    EXPECT_EQ(layout_of(grid).points.size(), 1u);
}

TEST(Grid, uniformity_is_minimum_over_mean_outside_solids) {
    GridResult grid;
    for (const double lux : {300.0, 500.0, 700.0}) {
        PointResult point;
        point.value.direct = {lux};
        point.value.error.mesh = lux / 100.0;
        grid.points.push_back(point);
    }
    PointResult inside;
    inside.value.inside_solid = true;
    grid.points.push_back(inside);
    const GridFigures figures = figures_of(grid);
    EXPECT_EQ(figures.points, 3);
    EXPECT_DOUBLE_EQ(figures.mean, 500.0);
    EXPECT_DOUBLE_EQ(figures.min, 300.0);
    EXPECT_DOUBLE_EQ(figures.max, 700.0);
    EXPECT_DOUBLE_EQ(figures.uniformity, 0.6);
    EXPECT_DOUBLE_EQ(figures.largest_error, 7.0);
}

TEST(Grid, a_grid_wholly_inside_a_solid_has_no_figures) {
    GridResult grid;
    grid.points.resize(2);
    for (PointResult& point : grid.points) point.value.inside_solid = true;
    EXPECT_EQ(figures_of(grid).points, 0);
    EXPECT_EQ(figures_of(grid).uniformity, 0.0);
}

}  // namespace
}  // namespace hanei
