#include "ui/view/difference.h"

#include "tests/unit/view/room_by_hand.h"
#include "ui/view/colour_scale.h"
#include "ui/view/histogram.h"

#include <gtest/gtest.h>

namespace hanei {
namespace {

using namespace test;

LightField even(double lux) {
    return [lux](const Vec3&, const Vec3&) { return Light{lux, 0.25 * lux, 2.0 * lux}; };
}

TEST(Difference, of_a_room_with_itself_is_none_anywhere) {
    const auto room = solution_by_hand(furnished_room(), pleasant_light);
    const SolutionSnapshot made = difference_of(*room, *room);
    double greatest = 0.0;
    for (const DisplayCell& cell : made->display->cells)
        for (const std::uint32_t corner : cell.corner)
            greatest = std::max(
                greatest, static_cast<double>(std::abs(value_of(made->display->vertices[corner], LightPart::total))));
    EXPECT_LT(greatest, 25.0) << "two millimetres inside an edge, of light that bends";
    EXPECT_LE(suggested_difference(*made, LightPart::total), 5.0);
}

TEST(Difference, is_signed_and_told_part_by_part) {
    const Scene scene = furnished_room();
    const auto first = solution_by_hand(scene, even(400.0)), second = solution_by_hand(scene, even(300.0), 0.31);
    const SolutionSnapshot made = difference_of(*first, *second);
    for (const DisplayCell& cell : made->display->cells) {
        for (const std::uint32_t corner : cell.corner) {
            const DisplayVertex& vertex = made->display->vertices[corner];
            ASSERT_NEAR(static_cast<double>(value_of(vertex, LightPart::direct)), -100.0, 1e-3);
            ASSERT_NEAR(static_cast<double>(value_of(vertex, LightPart::interreflected)), -25.0, 1e-3);
            ASSERT_NEAR(static_cast<double>(value_of(vertex, LightPart::total)), -125.0, 1e-3);
        }
    }
    EXPECT_EQ(suggested_difference(*made, LightPart::total), 200.0);
}

TEST(Difference, says_where_the_first_room_had_no_such_surface) {
    const Scene scene = furnished_room();
    Scene without = scene;
    without.furniture.clear();
    const auto first = solution_by_hand(without, even(400.0)), second = solution_by_hand(scene, even(400.0));
    const SolutionSnapshot made = difference_of(*first, *second);
    std::size_t compared = 0, alone = 0;
    for (const DisplayCell& cell : made->display->cells) {
        const bool of_room = made->mesh->faces[cell.face].face.ref.object == scene.room->id;
        const float lux = value_of(made->display->vertices[cell.corner[0]], LightPart::total);
        const bool found = has_counterpart(static_cast<double>(lux));
        EXPECT_TRUE(found || !of_room);
        compared += found ? 1 : 0;
        alone += found ? 0 : 1;
    }
    EXPECT_GT(compared, 0U);
    EXPECT_GT(alone, 0U) << "a desk that was not there";
}

TEST(Difference, compares_grids_by_id_or_name_and_leaves_others_alone) {
    Scene scene = furnished_room();
    scene.grids.clear();
    for (const char* name : {"desk", "floor"}) {
        CalculationGrid grid;
        grid.id = scene.new_id();
        grid.name = name;
        scene.grids.push_back(grid);
    }
    auto first = std::make_shared<Solution>(*solution_by_hand(scene, even(400.0)));
    auto second = std::make_shared<Solution>(*first);
    const auto with_values = [](const CalculationGrid& grid, double lux) {
        GridResult result = layout_of(grid);
        result.grid = grid.id;
        for (PointResult& point : result.points) point.value.direct = {lux};
        return result;
    };
    first->grids = {with_values(scene.grids[0], 300.0)};
    second->grids = {with_values(scene.grids[0], 450.0), with_values(scene.grids[1], 200.0)};
    const std::vector<GridDifference> rows = compared_grids(*first, *second);
    ASSERT_EQ(rows.size(), 2U);
    EXPECT_EQ(rows[0].name, "desk");
    EXPECT_EQ(rows[0].first->mean, 300.0);
    EXPECT_EQ(rows[0].second->mean, 450.0);
    EXPECT_FALSE(rows[1].first) << "the first has no such grid";
    const SolutionSnapshot made = difference_of(*first, *second);
    ASSERT_EQ(made->grids.size(), 1U);
    EXPECT_EQ(figures_of(made->grids.front()).mean, 150.0);
}

TEST(ColoursOfDifferences, tell_more_from_less_and_from_nothing_to_compare) {
    const ViewOptions look = as_difference({}, 100.0);
    EXPECT_EQ(colour_of(0.0, look), difference_colours.none);
    EXPECT_EQ(colour_of(100.0, look), difference_colours.much_more);
    EXPECT_EQ(colour_of(-250.0, look), difference_colours.much_less);
    EXPECT_EQ(colour_of(static_cast<double>(no_counterpart), look), difference_colours.nothing);
    int striped = 0;
    for (int x = 0; x < 40; ++x) {
        striped += colour_of(-50.0, look, x, 0.0, 1.0) != colour_of(-50.0, look) ? 1 : 0;
        EXPECT_EQ(colour_of(50.0, look, x, 0.0, 1.0), colour_of(50.0, look));
    }
    EXPECT_GT(striped, 4);
    EXPECT_NEAR(lux_at(scale_position(-30.0, look), look), -30.0, 1e-12);  // rounding
}

TEST(Histogram, holds_all_the_area_of_a_square) {
    const auto square = single_cell({100.0F, 100.0F, 300.0F, 300.0F});
    ViewOptions look;
    look.steps = ColourSteps::linear;
    const LightHistogram made = histogram_of(*square, {}, look, 10);
    EXPECT_NEAR(made.area, 4.0, 1e-9);  // 2 m x 2 m
    EXPECT_NEAR(made.mean, 200.0, 1e-4);
    double area = 0.0;
    for (const LightHistogram::Bin& bin : made.bins) area += bin.area;
    EXPECT_NEAR(area, made.area, 1e-9);
    EXPECT_EQ(made.share_above(0.0), 1.0);
    EXPECT_NEAR(made.share_above(200.0), 0.5, 1e-9);
    EXPECT_EQ(made.share_above(1e6), 0.0);
}

TEST(Histogram, of_a_grid_is_of_its_points_and_nothing_of_what_they_do_not_have) {
    Scene scene = furnished_room();
    CalculationGrid grid;
    grid.id = scene.new_id();
    grid.along = {2.0, 0.0, 0.0};
    grid.across = {0.0, 1.0, 0.0};
    grid.spacing = 0.5;
    scene.grids = {grid};
    auto solution = std::make_shared<Solution>(*solution_by_hand(scene, even(400.0)));
    GridResult result = layout_of(grid);
    result.grid = grid.id;
    for (std::size_t k = 0; k < result.points.size(); ++k) result.points[k].value.direct = {k % 2 == 0 ? 100.0 : 500.0};
    solution->grids = {result};
    const LightHistogram made = histogram_of(*solution, grid.id, {});
    EXPECT_NEAR(made.area, 2.0, 1e-9);
    EXPECT_NEAR(made.mean, 300.0, 1e-9);
    EXPECT_NEAR(made.uniformity(), 1.0 / 3.0, 1e-9);
    EXPECT_NEAR(made.share_above(300.0), 0.5, 1e-9);
    ViewOptions unshadowed;
    unshadowed.part = LightPart::unshadowed;
    EXPECT_TRUE(histogram_of(*solution, grid.id, unshadowed).samples.empty());
}

}  // namespace
}  // namespace hanei
