/// Control groups, light scenes and arrangements: what they mean and what is wrong with them.
#include "engine/scene/dimmers.h"
#include "engine/scene/layout.h"
#include "engine/scene/scene_check.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <limits>
#include <numbers>

namespace hanei {
namespace {

/// Three lamps, two of them of one control group, and a light scene for it.
Scene lit_scene() {
    Scene scene;
    for (int k = 0; k < 3; ++k) {
        Luminaire lamp;
        lamp.id = scene.new_id();
        lamp.position = {static_cast<double>(k), 0.0, 2.0};
        scene.luminaires.push_back(lamp);
    }
    scene.control_groups.push_back({scene.new_id(), "row", 0.5, 0.0, {}});
    scene.luminaires[0].group = scene.luminaires[1].group = scene.control_groups[0].id;
    scene.light_scenes.push_back({scene.new_id(), "dim", {{scene.control_groups[0].id, 0.2}}, {}});
    scene.arrangements.push_back({scene.new_id(),
                                  "line",
                                  LineLayout{{0, 0, 2}, {1, 0, 2}, 2},
                                  0.0,
                                  {scene.luminaires[0].id, scene.luminaires[1].id},
                                  {}});
    return scene;
}

/// "field: message" of every finding.
std::string findings_of(const Scene& scene) {
    std::string text;
    for (const Diagnostic& finding : check_scene(scene)) text += finding.place.field + ": " + finding.message + "\n";
    return text;
}

void expect_found(const Scene& scene, const std::string& field, const std::string& words) {
    const std::string text = findings_of(scene);
    EXPECT_EQ(text.rfind(field + ": ", 0), 0U) << text;
    EXPECT_NE(text.find(words), std::string::npos) << text;
    EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 1) << text;
}

TEST(Dimmers, a_luminaire_shines_by_its_own_dimmer_times_its_group_s) {
    Scene scene = lit_scene();
    scene.luminaires[0].dimming = 0.5;
    EXPECT_EQ(dimming_of(scene, scene.luminaires[0]), 0.25);
    EXPECT_EQ(dimming_of(scene, scene.luminaires[1]), 0.5);
    EXPECT_EQ(dimming_of(scene, scene.luminaires[2]), 1.0) << "it has no group";
}

TEST(Dimmers, a_group_that_has_a_colour_gives_it_to_its_luminaires) {
    Scene scene = lit_scene();
    scene.luminaires[0].colour_temperature = 3000.0;
    EXPECT_EQ(colour_temperature_of(scene, scene.luminaires[0]), 3000.0);
    scene.control_groups[0].colour_temperature = 4000.0;
    EXPECT_EQ(colour_temperature_of(scene, scene.luminaires[0]), 4000.0);
    EXPECT_EQ(colour_temperature_of(scene, scene.luminaires[1]), 4000.0);
    EXPECT_EQ(colour_temperature_of(scene, scene.luminaires[2]), 0.0);
}

TEST(Layouts, a_field_leaves_half_a_spacing_at_its_borders) {
    const auto places = places_of(FieldLayout{{1, 1, 2.7}, {6, 0, 0}, {0, 4, 0}, 3, 2});
    ASSERT_EQ(places.size(), 6U);
    EXPECT_EQ(places[0].position, Vec3(2, 2, 2.7));
    EXPECT_EQ(places[2].position, Vec3(6, 2, 2.7));
    EXPECT_EQ(places[3].position, Vec3(2, 4, 2.7));
}

TEST(Layouts, a_line_runs_from_end_to_end_and_one_alone_hangs_in_the_middle) {
    const auto places = places_of(LineLayout{{0, 0, 2}, {4, 2, 2}, 3});
    ASSERT_EQ(places.size(), 3U);
    EXPECT_EQ(places[0].position, Vec3(0, 0, 2));
    EXPECT_EQ(places[1].position, Vec3(2, 1, 2));
    EXPECT_EQ(places[2].position, Vec3(4, 2, 2));
    EXPECT_EQ(places_of(LineLayout{{0, 0, 2}, {4, 2, 2}, 1}).front().position, Vec3(2, 1, 2));
}

TEST(Layouts, luminaires_of_a_circle_face_outward_when_asked) {
    const auto places = places_of(CircleLayout{{1, 1, 2}, 2.0, 4, 0.0, true});
    ASSERT_EQ(places.size(), 4U);
    constexpr double rounding = 1e-12;
    EXPECT_LT(glm::length(places[1].position - Vec3(1, 3, 2)), rounding);
    EXPECT_NEAR(places[1].yaw, 0.5 * std::numbers::pi, rounding);
    EXPECT_EQ(places_of(CircleLayout{{1, 1, 2}, 2.0, 4, 0.0, false})[1].yaw, 0.0);
}

TEST(Layouts, without_luminaires_have_no_places) {
    EXPECT_TRUE(places_of(LineLayout{{}, {}, 0}).empty());
    EXPECT_TRUE(places_of(FieldLayout{{}, {}, {}, -1, 3}).empty());
    EXPECT_EQ(place_count(CircleLayout{{}, 1.0, -5, 0.0, false}), 0U);
}

TEST(SceneCheck, lighting_without_faults_is_not_complained_about) { EXPECT_EQ(findings_of(lit_scene()), ""); }

TEST(SceneCheck, a_control_group_dims_within_its_range_and_has_a_possible_colour) {
    Scene scene = lit_scene();
    scene.control_groups[0].dimming = 1.01;
    expect_found(scene, "control_groups[0].dimming", "allowed are 0 to 1");
    scene = lit_scene();
    scene.control_groups[0].colour_temperature = 500.0;
    expect_found(scene, "control_groups[0].colour_temperature_k", "allowed are 0 (neutral) and 1000 to 25000 K");
    scene = lit_scene();
    scene.luminaires[2].group = ObjectId{77};
    expect_found(scene, "luminaires[2].group", "no such control group");
}

TEST(SceneCheck, a_light_scene_names_groups_that_are_there_and_each_once) {
    Scene scene = lit_scene();
    scene.light_scenes[0].levels[0].dimming = -0.1;
    expect_found(scene, "light_scenes[0].levels[0].dimming", "allowed are 0 to 1");
    scene = lit_scene();
    scene.light_scenes[0].levels[0].group = scene.luminaires[0].id;
    expect_found(scene, "light_scenes[0].levels[0].group", "no such control group");
    scene = lit_scene();
    scene.light_scenes[0].levels.push_back(scene.light_scenes[0].levels[0]);
    expect_found(scene, "light_scenes[0].levels[1].group", "keep one");
    scene.light_scenes[0].levels.clear();
    expect_found(scene, "light_scenes[0].levels", "sets no control group");
}

TEST(SceneCheck, an_arrangement_has_one_luminaire_or_none_a_place) {
    Scene scene = lit_scene();
    scene.arrangements[0].luminaires[1] = {};
    EXPECT_EQ(findings_of(scene), "") << "a place may be empty";
    scene.arrangements[0].luminaires[0] = {};
    expect_found(scene, "arrangements[0].luminaires", "dissolve it");
    scene = lit_scene();
    scene.arrangements[0].luminaires.push_back(scene.luminaires[2].id);
    expect_found(scene, "arrangements[0].luminaires", "found 3 for 2 places");
    scene = lit_scene();
    scene.arrangements[0].luminaires[1] = scene.luminaires[0].id;
    expect_found(scene, "arrangements[0].luminaires[1]", "in an arrangement already");
    scene = lit_scene();
    scene.arrangements[0].luminaires[1] = ObjectId{99};
    expect_found(scene, "arrangements[0].luminaires[1]", "no such luminaire");
}

TEST(SceneCheck, a_layout_has_finite_figures_and_a_sane_count) {
    Scene scene = lit_scene();
    scene.arrangements[0].layout = CircleLayout{{0, 0, 2}, -1.0, 2, 0.0, false};
    expect_found(scene, "arrangements[0].layout.radius", "must be 0 or more");
    scene.arrangements[0].layout = LineLayout{{std::numeric_limits<double>::quiet_NaN(), 0, 2}, {1, 0, 2}, 2};
    EXPECT_TRUE(has_errors(check_scene(scene)));
    scene.arrangements[0].layout = FieldLayout{{}, {1, 0, 0}, {0, 1, 0}, 1, most_in_a_row + 1};
    scene.arrangements[0].luminaires.assign(most_in_a_row + 1, {});
    scene.arrangements[0].luminaires[0] = scene.luminaires[0].id;
    expect_found(scene, "arrangements[0].layout.rows", "allowed are 1 to 200");
}

}  // namespace
}  // namespace hanei
