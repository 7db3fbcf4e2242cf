#include "engine/report/report.h"

#include "engine/report/numbers.h"
#include "engine/report/report_json.h"
#include "engine/report/sweep_report.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace hanei {
namespace {

Solution one_point_solution() {
    Scene scene;
    scene.title = "room";
    scene.points.push_back({scene.new_id(), "desk, left", {1.0, 2.0, 0.75}, {0.0, 0.0, 1.0}, {}});
    Solution solution;
    PointResult point;
    point.point = scene.points.front().id;
    point.position = scene.points.front().position;
    point.value.direct = {300.25};
    point.value.interreflected = {112.5};
    point.value.error = {.iteration = 0.25, .mesh = 2.5, .skipped = 0.0, .sampling = 0.0};
    solution.points.push_back(point);
    solution.scene = std::make_shared<const Scene>(scene);
    solution.mesh = std::make_shared<const Mesh>();
    return solution;
}

TEST(Report, an_illuminance_shows_the_digits_its_error_allows) {
    EXPECT_EQ(illuminance_text({412.3456}, 0.0), "412.3 lx");
    EXPECT_EQ(illuminance_text({412.3456}, 3.2), "412 ± 3 lx");
    EXPECT_EQ(illuminance_text({412.3456}, 0.08), "412.35 ± 0.08 lx");
    EXPECT_EQ(illuminance_text({412.3456}, 120.0), "412 ± 120 lx");
    EXPECT_EQ(illuminance_text({412.3456}, 1e30), "412 lx, no bound");
}

TEST(Report, a_field_with_a_comma_is_quoted) {
    EXPECT_EQ(csv_field("plain"), "plain");
    EXPECT_EQ(csv_field("desk, left"), "\"desk, left\"");
    EXPECT_EQ(csv_field("3\" pipe"), "\"3\"\" pipe\"");
}

TEST(Report, csv_holds_every_value_with_its_error_bar) {
    const std::string csv = values_csv(one_point_solution());
    EXPECT_NE(csv.find("point,\"desk, left\",1,2,0.75,0,0,1,412.75,300.25,112.5,2.75,0.25,2.5,0,0,0\n"),
              std::string::npos)
        << csv;
}

TEST(Report, json_holds_the_same_figures) {
    const auto json = nlohmann::json::parse(values_json(one_point_solution()));
    EXPECT_EQ(json["points"][0]["name"], "desk, left");
    EXPECT_EQ(json["points"][0]["total_lx"], 412.75);
    EXPECT_EQ(json["points"][0]["error_lx"]["total"], 2.75);
}

Sweep two_runs() {
    const std::vector<SweepErrors> poor{{"all", 0.1, 0.2, 30.0}, {"floor, left", 0.1, 0.2, 0.3}};
    const std::vector<SweepErrors> good{{"all", 0.01, 0.02, 0.03}, {"floor, left", 0.0, 0.0, 0.0}};
    return {"the expected values of <S2>",
            {{Method::paper, 0.5, 100, 12.0, poor}, {Method::patch, 0.5, 90, 14.0, good}}};
}

std::size_t count_of(const std::string& text, const std::string& part) {
    std::size_t count = 0;
    for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++count;
    return count;
}

TEST(Report, a_sweep_is_one_line_a_run_and_set_of_points) {
    const std::string csv = sweep_csv(two_runs());
    EXPECT_EQ(count_of(csv, "\n"), 5U);
    EXPECT_NE(csv.find("paper,0.5,100,12.00,all,10,20,3000\n"), std::string::npos);
    EXPECT_NE(csv.find(",floor  left,"), std::string::npos) << "a comma in a name would begin a column";
}

TEST(Report, a_sweep_is_drawn_for_every_set_and_figure) {
    const std::string svg = sweep_svg(two_runs(), "a < b");
    EXPECT_NE(svg.find("a &lt; b"), std::string::npos);
    EXPECT_NE(svg.find("against the expected values of &lt;S2>"), std::string::npos);
    EXPECT_EQ(count_of(svg, "greatest error"), 2U);
    EXPECT_EQ(count_of(svg, "<title>"), 9U);  // twelve figures, three of them 0: nothing to draw on decades
    EXPECT_EQ(count_of(svg, "nan"), 0U);
    EXPECT_EQ(count_of(sweep_svg({}, "nothing"), "nan"), 0U);
}

}  // namespace
}  // namespace hanei
