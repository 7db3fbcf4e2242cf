#include "engine/project/json_fields.h"
#include "engine/project/project_settings.h"
#include "project_scene_with_everything.h"

#include <bit>
#include <cmath>
#include <gtest/gtest.h>
#include <limits>
#include <numbers>
#include <random>

namespace hanei {
namespace {

/// The project of a text that has no errors.
Project read(const std::string& text) {
    ProjectRead read = read_project_text(text, "room.hanei");
    for (const Diagnostic& finding : read.findings)
        if (finding.severity == Severity::error) ADD_FAILURE() << to_text(finding);
    return read.project.value_or(Project{});
}

TEST(ProjectText, a_project_with_every_kind_of_object_comes_back_equal) {
    const Project project = project_with_everything();
    const std::string text = project_text(project);
    EXPECT_EQ(read(text), project);
    EXPECT_EQ(project_text(read(text)), text);
}

TEST(ProjectText, an_empty_project_comes_back_equal) { EXPECT_EQ(read(project_text(Project{})), Project{}); }

TEST(ProjectText, figures_keep_every_bit) {
    std::mt19937_64 random(1);
    Project project;
    for (int i = 0; i < 2000; ++i) {
        const double value = std::bit_cast<double>(random());
        if (std::isfinite(value))
            project.scene.points.push_back({project.scene.new_id(), "", {value, -value, 0.0}, {0, 0, 1}, {}});
    }
    project.scene.points.push_back({project.scene.new_id(), "", {5e-324, 1.7976931348623157e308, -0.0}, {0, 0, 1}, {}});
    const Project back = read(project_text(project));
    ASSERT_EQ(back.scene.points.size(), project.scene.points.size());
    for (std::size_t i = 0; i < back.scene.points.size(); ++i)
        for (glm::length_t axis = 0; axis < 3; ++axis)
            ASSERT_EQ(std::bit_cast<std::uint64_t>(back.scene.points[i].position[axis]),
                      std::bit_cast<std::uint64_t>(project.scene.points[i].position[axis]));
}

TEST(ProjectText, angles_are_degrees_in_the_file_and_keep_every_bit) {
    std::mt19937_64 random(2);
    std::uniform_real_distribution<double> turn(-10.0, 10.0);
    for (int i = 0; i < 20'000; ++i) {
        const double angle = i % 2 == 0 ? turn(random) : std::ldexp(turn(random), -(i % 60));
        const double back = scaled(json_scaled(angle, degree), degree);
        ASSERT_EQ(std::bit_cast<std::uint64_t>(angle), std::bit_cast<std::uint64_t>(back)) << angle;
    }
}

TEST(ProjectText, angles_that_people_type_stay_as_they_typed_them) {
    Project project;
    Luminaire luminaire;
    luminaire.id = project.scene.new_id();
    luminaire.yaw = 90.0 * std::numbers::pi / 180.0;
    luminaire.tilt = 12.5 * std::numbers::pi / 180.0;
    luminaire.roll = -std::numbers::pi;
    project.scene.luminaires.push_back(luminaire);
    const std::string text = project_text(project);
    EXPECT_NE(text.find("\"yaw_deg\": 90,"), std::string::npos) << text;
    EXPECT_NE(text.find("\"tilt_deg\": 12.5,"), std::string::npos) << text;
    EXPECT_NE(text.find("\"roll_deg\": -180,"), std::string::npos) << text;
}

TEST(ProjectText, every_degree_of_a_turn_is_written_without_decimals) {
    for (int angle = -360; angle <= 360; ++angle) {
        JsonValue typed = json_number(angle);
        EXPECT_EQ(json_scaled(scaled(typed, degree), degree).text, std::to_string(angle));
    }
}

TEST(ProjectText, settings_at_both_ends_of_their_ranges_read_back) {
    for_each_option([](const auto& option) {
        for (const auto shown : {option.low, option.high}) {
            Project project;
            // as the panel stores what it shows
            project.settings.*option.member =
                static_cast<decltype(option.low)>(static_cast<double>(shown) / option.scale);
            EXPECT_EQ(read(project_text(project)).settings, project.settings) << option.name;
        }
    });
}

TEST(ProjectText, percent_settings_read_as_they_were_typed) {
    Project project;
    project.settings.accuracy = 0.001;
    EXPECT_NE(project_text(project).find("\"accuracy_percent\": 0.1,"), std::string::npos);
    EXPECT_EQ(
        read(R"({"format": "hanei-project", "version": 1, "settings": {"accuracy_percent": 0.1}})").settings.accuracy,
        0.001);
}

TEST(ProjectText, materials_are_named_where_their_names_are_unique) {
    const std::string text = project_text(project_with_everything());
    EXPECT_NE(text.find("\"material\": \"wood\""), std::string::npos);
    EXPECT_NE(text.find("\"walls\": [3, 3, \"wood\", 3]"), std::string::npos) << text;
}

TEST(ProjectText, objects_without_ids_get_new_ones_above_all_others) {
    const Project project = read(R"({"format": "hanei-project", "version": 1,
        "materials": [{"name": "a", "reflectance": 0.5}, {"id": 40, "name": "b", "reflectance": 0.5}],
        "points": [{"position": [0, 0, 0]}]})");
    EXPECT_EQ(project.scene.materials[0].id.value, 41U);
    EXPECT_EQ(project.scene.materials[1].id.value, 40U);
    EXPECT_EQ(project.scene.points[0].id.value, 42U);
    EXPECT_EQ(project.scene.last_id, 42U);
}

TEST(ProjectText, one_material_can_be_given_for_all_walls) {
    const Project project =
        read(R"({"format": "hanei-project", "version": 1, "materials": [{"name": "a", "reflectance": 0.5}],
        "room": {"plan": [[0, 0], [1, 0], [0, 1]], "height": 2, "floor": "a", "ceiling": 1, "walls": "a"}})");
    EXPECT_EQ(project.scene.room->wall_materials, (std::vector<ObjectId>(3, ObjectId{1})));
    EXPECT_EQ(project.scene.room->ceiling_material, ObjectId{1});
}

TEST(ProjectText, fields_of_a_later_version_are_kept_and_each_is_warned_about) {
    const std::string text = project_text(project_with_everything());
    const ProjectRead read = read_project_text(text, "room.hanei");
    int warnings = 0;
    for (const Diagnostic& finding : read.findings)
        warnings += finding.message.find("does not know") != std::string::npos ? 1 : 0;
    // material, room, sub-area, desk, part, stool, surface, photometry, serial, opening.glass, light scene, three
    // layouts, grid, group, settings.sky, notes, colour scale
    EXPECT_EQ(warnings, 19);
    EXPECT_NE(text.find("\"serial\": 12345678901234567890"), std::string::npos);
    EXPECT_NE(text.find("\"b\": 1.50"), std::string::npos);
}

TEST(ProjectText, a_control_group_that_only_a_luminaire_names_is_made) {
    const Project project = read(R"({"format": "hanei-project", "version": 1, "luminaires": [
        {"position": [0, 0, 2], "opening": {"kind": "point"}, "flux_lm": 9, "group": "row"},
        {"position": [1, 0, 2], "opening": {"kind": "point"}, "flux_lm": 9, "group": "row"}],
        "light_scenes": [{"name": "dim", "levels": [{"group": "row", "dimming": 0.25}]}]})");
    ASSERT_EQ(project.scene.control_groups.size(), 1U);
    EXPECT_EQ(project.scene.luminaires[1].group, project.scene.control_groups[0].id);
    ASSERT_EQ(project.scene.light_scenes.size(), 1U);
    EXPECT_EQ(project.scene.light_scenes[0].levels,
              (std::vector<LightScene::Level>{{project.scene.control_groups[0].id, 0.25}}));
}

TEST(ProjectText, unknown_fields_of_an_opening_go_back_into_the_opening) {
    const std::string text = project_text(project_with_everything());
    EXPECT_NE(text.find(R"("opening": {"kind": "point", "glass": "opal"})"), std::string::npos) << text;
}

TEST(ProjectText, names_that_are_no_utf_8_do_not_make_an_unreadable_file) {
    Project project;
    project.scene.title = "caf\xe9";
    EXPECT_EQ(read(project_text(project)).scene.title, "caf\xef\xbf\xbd");
}

TEST(ProjectText, a_clockwise_plan_is_turned_round_with_its_walls_and_doors) {
    const ProjectRead read = read_project_text(R"({"format": "hanei-project", "version": 1,
        "materials": [{"name": "a", "reflectance": 0.1}, {"name": "b", "reflectance": 0.2}, {"name": "c", "reflectance": 0.3}],
        "room": {"plan": [[0, 0], [0, 3], [4, 0]], "height": 2, "floor": "a", "ceiling": "a", "walls": ["a", "b", "c"],
                 "sub_areas": [{"face": "wall 0", "low": [0.5, 0], "high": [1, 2], "material": "b"}]}})",
                                               "room.hanei");
    ASSERT_TRUE(read.project.has_value());
    const Room& room = *read.project->scene.room;
    EXPECT_EQ(room.plan, (std::vector<Vec2>{{0, 0}, {4, 0}, {0, 3}}));
    EXPECT_EQ(room.wall_materials, (std::vector<ObjectId>{{3}, {2}, {1}}));
    EXPECT_EQ(room.sub_areas[0].face, Room::wall_face(2));
    EXPECT_EQ(room.sub_areas[0].low, (Vec2{2.0, 0.0}));
    EXPECT_EQ(room.sub_areas[0].high, (Vec2{2.5, 2.0}));
    ASSERT_EQ(read.findings.size(), 1U);
    EXPECT_EQ(
        to_text(read.findings[0]),
        "room.hanei:3: room.plan: warning: the plan ran clockwise; it was turned round together with its walls and "
        "their sub-areas");
}

TEST(ProjectText, an_inside_out_solid_is_turned_round) {
    Project project = project_with_everything();
    auto& wedge = std::get<SolidShape>(project.scene.furniture[0].parts[1].shape);
    for (std::vector<int>& face : wedge.faces) std::reverse(face.begin(), face.end());
    const ProjectRead read = read_project_text(project_text(project), "room.hanei");
    ASSERT_TRUE(read.project.has_value());
    EXPECT_EQ(std::get<SolidShape>(read.project->scene.furniture[0].parts[1].shape).faces[0],
              (std::vector<int>{0, 2, 1}));
}

TEST(ProjectText, unknown_fields_of_a_cut_go_back_into_the_cut_and_go_with_it) {
    const std::string text =
        R"({"format": "hanei-project", "version": 1, "views": [{"eye": [0, 0, 1], "target": [1, 0, 1],
            "cut": {"normal": [0, 0, 1], "offset": 2, "hatch": "brick"}}]})";
    ProjectRead read = read_project_text(text, "p");
    ASSERT_TRUE(read.project);
    EXPECT_NE(project_text(*read.project).find(R"("offset": 2, "hatch": "brick"})"), std::string::npos)
        << project_text(*read.project);
    read.project->scene.views.front().cut.reset();
    EXPECT_EQ(project_text(*read.project).find("cut"), std::string::npos);
}

}  // namespace
}  // namespace hanei
