#include "engine/report/measured_report.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace hanei {
namespace {

/// A grid "Desk" of two points with 100 and 200 lx, each known to 1 lx, and a point "Door" of 50 lx.
Solution small_solution() {
    Scene scene;
    CalculationGrid desk;
    desk.id = scene.new_id();
    desk.name = "Desk";
    desk.spacing = 0.5;
    scene.grids.push_back(desk);
    scene.points.push_back({scene.new_id(), "Door", {1.0, 2.0, 1.0}, {0.0, 1.0, 0.0}, {}});
    const auto result = [](ObjectId id, double x, double lux) {
        PointResult point;
        point.point = id;
        point.position = {x, 0.5, 0.75};
        point.value.direct = {lux};
        point.value.error.mesh = 1.0;
        return point;
    };
    Solution solution;
    GridResult grid;
    grid.grid = desk.id;
    grid.columns = 2;
    grid.rows = 1;
    grid.points = {result({}, 0.25, 100.0), result({}, 0.75, 200.0)};
    solution.grids.push_back(grid);
    solution.points.push_back(result(scene.points[0].id, 1.0, 50.0));
    solution.scene = std::make_shared<const Scene>(scene);
    solution.mesh = std::make_shared<const Mesh>();
    return solution;
}

MeasuredValue value(int line, std::string set, std::optional<int> index, double lux,
                    std::optional<double> uncertainty = {}) {
    MeasuredValue made;
    made.line = line;
    made.set = std::move(set);
    made.index = index;
    made.lux = lux;
    made.uncertainty = uncertainty;
    return made;
}

TEST(MeasuredReport, deviations_are_counted_a_set_and_all_together) {
    const MeasuredValues measured{
        "m.csv", {value(2, "Desk", 1, 100.5, 0.1), value(3, "", 2, 190.0, 20.0), value(4, "Door", {}, 40.0)}, 0};
    const MeasuredComparison made = compared_with(small_solution(), measured);
    ASSERT_TRUE(made.faults.empty()) << to_text(made.faults[0]);
    ASSERT_EQ(made.sets.size(), 3U);
    const MeasuredSet& desk = made.sets[0];
    EXPECT_EQ(desk.name, "Desk");
    EXPECT_EQ(desk.points, 2U);
    EXPECT_DOUBLE_EQ(desk.lux.mean, 5.25);
    EXPECT_DOUBLE_EQ(desk.lux.max, 10.0);
    EXPECT_DOUBLE_EQ(desk.share.max, 10.0 / 190.0);
    EXPECT_EQ(desk.within_ours, 1U);  // 0.5 lx off, known to 1 lx
    EXPECT_EQ(desk.with_theirs, 2U);
    EXPECT_EQ(desk.within_theirs, 1U);  // 10 lx off, known to 20 lx
    EXPECT_EQ(desk.within_both, 2U);
    EXPECT_EQ(made.sets[2].name, "all");
    EXPECT_EQ(made.sets[2].points, 3U);
    EXPECT_EQ(made.pairs[made.sets[2].largest].theirs.line, 3);
    EXPECT_NE(measured_text(made).find("largest, Desk: line 3: Desk 2 at 0.750, 0.500, 0.750: theirs 190, ours 200"),
              std::string::npos)
        << measured_text(made);
}

TEST(MeasuredReport, the_share_of_a_dark_place_is_of_a_tenth_of_the_mean) {
    const MeasuredValues measured{"m.csv", {value(2, "Desk", 1, 0.0), value(3, "Desk", 2, 200.0)}, 0};
    EXPECT_DOUBLE_EQ(compared_with(small_solution(), measured).sets[0].share.max, 100.0 / 10.0);
}

TEST(MeasuredReport, places_that_the_scene_does_not_have_are_faults_with_their_line) {
    const MeasuredValues measured{
        "m.csv", {value(2, "Floor", 1, 1.0), value(3, "Desk", 3, 1.0), value(4, "Window", {}, 1.0)}, 0};
    const MeasuredComparison made = compared_with(small_solution(), measured);
    ASSERT_EQ(made.faults.size(), 3U);
    EXPECT_TRUE(made.sets.empty());
    EXPECT_EQ(to_text(made.faults[0]), "m.csv:2: set: no calculation grid \"Floor\"; there are \"Desk\", \"Door\"");
    EXPECT_EQ(to_text(made.faults[1]), "m.csv:3: index: 3 is beyond the grid \"Desk\", which has points 1 to 2");
    EXPECT_NE(to_text(made.faults[2]).find("m.csv:4: set: no calculation point \"Window\""), std::string::npos);
}

TEST(MeasuredReport, an_index_beyond_all_grids_in_an_empty_scene_is_a_fault) {
    Solution empty;
    empty.scene = std::make_shared<const Scene>();
    empty.mesh = std::make_shared<const Mesh>();
    const MeasuredComparison made = compared_with(empty, {"m.csv", {value(2, "", 1, 1.0)}, 0});
    ASSERT_EQ(made.faults.size(), 1U);
    EXPECT_NE(made.faults[0].message.find("the scene has none"), std::string::npos) << made.faults[0].message;
}

TEST(MeasuredReport, places_inside_solids_are_left_out_and_counted) {
    Solution solution = small_solution();
    solution.grids[0].points[0].value.inside_solid = true;
    const MeasuredComparison made =
        compared_with(solution, {"m.csv", {value(2, "Desk", 1, 9.0), value(3, "Desk", 2, 200.0)}, 0});
    EXPECT_EQ(made.inside, 1U);
    EXPECT_EQ(made.sets.at(0).points, 1U);
    solution.grids[0].points[1].value.inside_solid = true;
    const MeasuredComparison none = compared_with(solution, {"m.csv", {value(2, "Desk", 1, 9.0)}, 0});
    EXPECT_EQ(none.faults.size(), 1U);
}

TEST(MeasuredReport, json_and_csv_hold_every_pair) {
    const MeasuredComparison made =
        compared_with(small_solution(), {"m.csv", {value(2, "Desk", 1, 100.5, 0.25), value(3, "Door", {}, 40.0)}, 4});
    const auto json = nlohmann::json::parse(measured_json(made));
    EXPECT_EQ(json["points"].size(), 2U);
    EXPECT_EQ(json["points"][0]["uncertainty_lx"], 0.25);
    EXPECT_EQ(json["sets"][0]["largest"]["line"], 2);
    EXPECT_EQ(json["without_value"], 4);
    EXPECT_NE(measured_csv(made).find("\n2,Desk,1,0.25,0.5,0.75,100.5,0.25,100,1,-0.5\n"), std::string::npos)
        << measured_csv(made);
}

}  // namespace
}  // namespace hanei
