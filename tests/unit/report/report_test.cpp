#include "engine/report/report.h"

#include "engine/report/numbers.h"
#include "engine/report/report_json.h"

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

}  // namespace
}  // namespace hanei
