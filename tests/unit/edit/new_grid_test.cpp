#include "engine/edit/edit.h"
#include "engine/scene/grid_spacing.h"

#include <gtest/gtest.h>

namespace hanei {
namespace {

TEST(AGrid, added_to_ground_kilometres_wide_can_be_computed) {
    Scene scene;
    scene.room = Room{};
    scene.room->plan = {{0.0, 0.0}, {3000.0, 0.0}, {3000.0, 3000.0}, {0.0, 3000.0}};
    const CalculationGrid grid = with_grid(scene).scene.grids.front();
    EXPECT_LE(grid_points(grid), 1e5);
    scene.room->plan = {{0.0, 0.0}, {6.0, 0.0}, {6.0, 4.0}, {0.0, 4.0}};
    EXPECT_EQ(with_grid(scene).scene.grids.front().spacing, 0.5);
}

}  // namespace
}  // namespace hanei
