#include "engine/scene/grid_spacing.h"


#include <gtest/gtest.h>

namespace hanei {
namespace {

CalculationGrid grid_of(double along, double across, double spacing) {
    CalculationGrid grid;
    grid.along = {along, 0.0, 0.0};
    grid.across = {0.0, across, 0.0};
    grid.spacing = spacing;
    return grid;
}

TEST(AGrid, has_the_cells_that_come_nearest_to_its_spacing) {
    EXPECT_EQ(grid_points(grid_of(6.0, 4.0, 0.5)), 96.0);
    EXPECT_EQ(grid_points(grid_of(6.0, 4.0, 0.7)), 9.0 * 6.0);
    EXPECT_EQ(grid_points(grid_of(0.1, 0.1, 5.0)), 1.0);
}

TEST(AGrid, is_spaced_as_the_standard_tabulates) {
    // EN 12464-1, table of examples: 1 m 0.2 m, 5 m 0.6 m, 10 m 1 m, 50 m 3 m, 100 m 5 m
    EXPECT_NEAR(standard_spacing(grid_of(1.0, 0.5, 1.0)), 0.2, 1e-12);
    EXPECT_NEAR(standard_spacing(grid_of(3.0, 5.0, 1.0)), 0.6, 0.05);
    EXPECT_NEAR(standard_spacing(grid_of(10.0, 5.0, 1.0)), 1.0, 1e-12);
    EXPECT_NEAR(standard_spacing(grid_of(50.0, 5.0, 1.0)), 3.0, 0.1);
    EXPECT_NEAR(standard_spacing(grid_of(100.0, 5.0, 1.0)), 5.0, 1e-12);
}

TEST(AGrid, of_the_least_spacing_can_be_computed_and_much_finer_cannot) {
    for (const double along : {0.05, 1.0, 7.3, 400.0, 1e4})
        for (const double across : {0.05, 2.0, 33.3, 1e4}) {
            CalculationGrid grid = grid_of(along, across, 1.0);
            grid.spacing = least_spacing(grid);
            EXPECT_LE(grid_points(grid), most_grid_points) << along << " x " << across;
            grid.spacing *= 0.7;
            EXPECT_GT(grid_points(grid), 0.9 * most_grid_points) << along << " x " << across;
        }
}

}  // namespace
}  // namespace hanei
