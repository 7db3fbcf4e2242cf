#include "engine/scene/scene_check.h"

#include "engine/scene/faces.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <limits>
#include <numbers>

namespace hanei {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

/// A furnished, lit room without faults.
Scene sound_scene() {
    Scene scene;
    scene.materials.push_back({scene.new_id(), "white", 0.7, {}});
    const ObjectId white = scene.materials[0].id;
    Room room;
    room.id = scene.new_id();
    room.plan = {{0, 0}, {4, 0}, {4, 3}, {0, 3}};
    room.floor_material = room.ceiling_material = white;
    room.wall_materials.assign(4, white);
    room.sub_areas.push_back({scene.new_id(), "door", Room::wall_face(0), {1, 0}, {2, 2}, white, {}});
    scene.room = room;
    Furniture desk;
    desk.id = scene.new_id();
    desk.name = "desk";
    desk.position = {2, 1, 0};
    desk.parts.push_back({BoxShape{{1, 0.6, 0.7}}, {0, 0, 0}, 0.0, white, {}});
    scene.furniture.push_back(desk);
    Luminaire panel;
    panel.id = scene.new_id();
    panel.name = "panel";
    panel.position = {2, 1.5, 2.7};
    panel.opening = PolygonOpening{{{{-0.3, -0.3, 0}, {-0.3, 0.3, 0}, {0.3, 0.3, 0}, {0.3, -0.3, 0}}, {}}};
    scene.luminaires.push_back(panel);
    scene.grids.push_back({scene.new_id(), "grid", {0, 0, 0.8}, {4, 0, 0}, {0, 3, 0}, 0.5, {}});
    scene.points.push_back({scene.new_id(), "point", {1, 2, 0.8}, {0, 0, 1}, {}});
    scene.views.push_back({scene.new_id(), "view", {0.5, 0.5, 1.6}, {2, 2, 1}, 0.9, false, {}});
    return scene;
}

/// The only finding; one with an empty message when there is not exactly one.
Diagnostic only_finding(const Scene& scene) {
    const Diagnostics findings = check_scene(scene);
    for (const Diagnostic& finding : findings)
        if (findings.size() != 1) ADD_FAILURE() << to_text(finding);
    return findings.size() == 1 ? findings[0] : Diagnostic{};
}

void expect_only(const Scene& scene, Severity severity, const std::string& field, const std::string& words) {
    const Diagnostic finding = only_finding(scene);
    EXPECT_EQ(finding.severity, severity) << finding.message;
    EXPECT_EQ(finding.place.field, field) << finding.message;
    EXPECT_NE(finding.message.find(words), std::string::npos) << finding.message;
}

TEST(SceneCheck, a_sound_scene_has_no_findings) { EXPECT_TRUE(check_scene(sound_scene()).empty()); }

TEST(SceneCheck, a_figure_that_is_no_number_is_an_error_with_the_objects_name_and_id) {
    Scene scene = sound_scene();
    scene.luminaires[0].yaw = nan;
    expect_only(scene, Severity::error, "luminaires[0].yaw_deg", "luminaire \"panel\"");
    EXPECT_EQ(only_finding(scene).place.object, scene.luminaires[0].id.value);
}

TEST(SceneCheck, figures_that_are_not_finite_are_found_wherever_they_stand) {
    const auto spoilt = [](auto spoil) {
        Scene scene = sound_scene();
        spoil(scene);
        return has_errors(check_scene(scene));
    };
    EXPECT_TRUE(spoilt([](Scene& s) { s.room->plan[1].x = nan; }));
    EXPECT_TRUE(spoilt([](Scene& s) { s.room->height = HUGE_VAL; }));
    EXPECT_TRUE(spoilt([](Scene& s) { s.room->floor_height = nan; }));
    EXPECT_TRUE(spoilt([](Scene& s) { s.room->sub_areas[0].low.y = nan; }));
    EXPECT_TRUE(spoilt([](Scene& s) { s.furniture[0].position.z = -HUGE_VAL; }));
    EXPECT_TRUE(spoilt([](Scene& s) { s.furniture[0].rotation = nan; }));
    EXPECT_TRUE(spoilt([](Scene& s) { s.furniture[0].parts[0].position.x = nan; }));
    EXPECT_TRUE(spoilt([](Scene& s) { std::get<BoxShape>(s.furniture[0].parts[0].shape).size.x = nan; }));
    EXPECT_TRUE(spoilt([](Scene& s) { s.luminaires[0].position.x = nan; }));
    EXPECT_TRUE(spoilt([](Scene& s) { std::get<PolygonOpening>(s.luminaires[0].opening).region.outline[2].y = nan; }));
    EXPECT_TRUE(spoilt([](Scene& s) { s.luminaires[0].output = LuminousFlux{nan}; }));
    EXPECT_TRUE(spoilt([](Scene& s) { s.grids[0].across.x = nan; }));
    EXPECT_TRUE(spoilt([](Scene& s) { s.points[0].normal.z = nan; }));
    EXPECT_TRUE(spoilt([](Scene& s) { s.views[0].eye.z = nan; }));
    EXPECT_TRUE(spoilt([](Scene& s) { s.maintenance_factor = nan; }));
    EXPECT_TRUE(spoilt([](Scene& s) { s.materials[0].reflectance = nan; }));
}

TEST(SceneCheck, a_reflectance_above_one_is_an_error_that_says_what_is_allowed) {
    Scene scene = sound_scene();
    scene.materials[0].reflectance = 1.2;
    expect_only(scene, Severity::error, "materials[0].reflectance", "found 1.2, allowed are 0 to 1");
}

TEST(SceneCheck, a_tint_has_luminance_one_and_the_error_says_which_would) {
    Scene scene = sound_scene();
    scene.materials[0].tint = {1.05, 1.0, 0.85281};  // 0.2126 x 1.05 + 0.7152 + 0.0722 x 0.85281 = 1.00000
    EXPECT_TRUE(check_scene(scene).empty());
    scene.materials[0].tint = {2.0, 2.0, 2.0};
    expect_only(scene, Severity::error, "materials[0].tint", "found 2, 2, 2 of luminance 2");
    expect_only(scene, Severity::error, "materials[0].tint", "write 1, 1, 1");
    scene.materials[0].tint = Vec3(0.0);
    expect_only(scene, Severity::error, "materials[0].tint", "found 0, 0, 0 of luminance 0, allowed is");
    scene.materials[0].tint = {-1.0, 1.5, 1.94};
    expect_only(scene, Severity::error, "materials[0].tint", "found -1, 1.5, 1.94, allowed are");
    scene.materials[0].tint.x = nan;
    expect_only(scene, Severity::error, "materials[0].tint", "no number");
}

TEST(SceneCheck, no_band_of_a_colour_reflects_more_than_it_gets) {
    Scene scene = sound_scene();
    scene.materials[0].reflectance = 0.5;
    scene.materials[0].tint = {2.5, 0.6, 0.5463};
    expect_only(scene, Severity::error, "materials[0].tint", "a band would reflect 1.25, allowed is 1 at most");
    scene.materials[0].reflectance = 0.4;
    EXPECT_TRUE(check_scene(scene).empty());
}

TEST(SceneCheck, a_colour_temperature_is_zero_or_one_that_light_can_have) {
    Scene scene = sound_scene();
    for (const double kelvin : {0.0, 1000.0, 2700.0, 25000.0}) {
        scene.luminaires[0].colour_temperature = kelvin;
        EXPECT_TRUE(check_scene(scene).empty()) << kelvin;
    }
    for (const double kelvin : {-1.0, 27.0, 999.0, 30000.0, nan}) {
        scene.luminaires[0].colour_temperature = kelvin;
        expect_only(scene, Severity::error, "luminaires[0].colour_temperature_k",
                    std::isnan(kelvin) ? "no number" : "allowed are 0 (neutral) and 1000 to 25000 K");
    }
}

TEST(SceneCheck, a_closed_room_that_reflects_all_light_is_warned_about) {
    Scene scene = sound_scene();
    scene.materials[0].reflectance = 1.0;
    expect_only(scene, Severity::warning, "room.walls", "never ends");
}

TEST(SceneCheck, ids_are_given_once_and_below_the_last) {
    Scene scene = sound_scene();
    scene.points[0].id = scene.grids[0].id;
    expect_only(scene, Severity::error, "points[0].id", "given twice");
    scene = sound_scene();
    scene.views[0].id = {};
    expect_only(scene, Severity::error, "views[0].id", "no id");
    scene = sound_scene();
    scene.views[0].id = {scene.last_id + 1};
    expect_only(scene, Severity::error, "views[0].id", "above the greatest");
}

TEST(SceneCheck, a_material_that_is_not_there_is_an_error) {
    Scene scene = sound_scene();
    scene.room->wall_materials[2] = {77};
    expect_only(scene, Severity::error, "room.walls[2]", "no material with the id 77");
}

TEST(SceneCheck, a_plan_that_crosses_itself_runs_clockwise_or_has_no_area_is_an_error) {
    Scene scene = sound_scene();
    scene.room->plan = {{0, 0}, {4, 3}, {4, 0}, {0, 3}};
    expect_only(scene, Severity::error, "room.plan", "cross");
    scene = sound_scene();
    std::reverse(scene.room->plan.begin(), scene.room->plan.end());
    expect_only(scene, Severity::error, "room.plan", "clockwise");
    scene = sound_scene();
    scene.room->plan.resize(2);
    scene.room->wall_materials.resize(2);
    expect_only(scene, Severity::error, "room.plan", "at least 3");
}

TEST(SceneCheck, every_wall_needs_a_material) {
    Scene scene = sound_scene();
    scene.room->wall_materials.pop_back();
    expect_only(scene, Severity::error, "room.walls", "3 materials for 4 walls");
}

TEST(SceneCheck, sub_areas_lie_on_a_wall_that_exists_and_have_an_area) {
    Scene scene = sound_scene();
    scene.room->sub_areas[0].face = Room::wall_face(4);
    expect_only(scene, Severity::error, "room.sub_areas[0].face", "no such wall");
    scene = sound_scene();
    scene.room->sub_areas[0].high.x = 1.0;
    expect_only(scene, Severity::error, "room.sub_areas[0].high", "no area");
    scene = sound_scene();
    scene.room->sub_areas[0].high.y = 5.0;
    expect_only(scene, Severity::warning, "room.sub_areas[0].high", "past its face");
}

TEST(SceneCheck, a_box_without_depth_is_an_error) {
    Scene scene = sound_scene();
    std::get<BoxShape>(scene.furniture[0].parts[0].shape).size.y = 0.0;
    expect_only(scene, Severity::error, "furniture[0].parts[0].box", "greater than 0");
}

SolidShape tetrahedron() {
    return {{{0, 0, 0}, {0.4, 0, 0}, {0, 0.4, 0}, {0, 0, 0.4}}, {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}}};
}

TEST(SceneCheck, solids_are_closed_and_right_side_out) {
    Scene scene = sound_scene();
    SolidShape shape = tetrahedron();
    scene.furniture[0].parts[0].shape = shape;
    EXPECT_TRUE(check_scene(scene).empty());
    shape.faces.pop_back();
    scene.furniture[0].parts[0].shape = shape;
    expect_only(scene, Severity::error, "furniture[0].parts[0].faces", "not closed");
    shape = tetrahedron();
    for (std::vector<int>& face : shape.faces) std::reverse(face.begin(), face.end());
    scene.furniture[0].parts[0].shape = shape;
    expect_only(scene, Severity::error, "furniture[0].parts[0].faces", "inside out");
    shape = tetrahedron();
    shape.faces[1][0] = 9;
    scene.furniture[0].parts[0].shape = shape;
    expect_only(scene, Severity::error, "furniture[0].parts[0].faces[1]", "vertex number 9");
}

TEST(SceneCheck, a_dented_solid_is_furniture_like_any_other) {
    // a roof whose ridge sinks below its eaves, over a square: closed, right side out, not convex
    SolidShape shape{
        {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}, {0.5, 0.5, 0.5}},
        {{0, 3, 2, 1},
         {0, 1, 5, 4},
         {1, 2, 6, 5},
         {2, 3, 7, 6},
         {3, 0, 4, 7},
         {4, 5, 8},
         {5, 6, 8},
         {6, 7, 8},
         {7, 4, 8}}};
    Scene scene = sound_scene();
    scene.furniture[0].parts[0].shape = shape;
    EXPECT_TRUE(check_scene(scene).empty());
    std::vector<Solid> solids = solids_of(scene);
    EXPECT_EQ(solids.size(), 4U);  // wedges that meet under the dent
    scene.furniture[0].parts[0].shape = tetrahedron();
    EXPECT_EQ(solids_of(scene).size(), 1U);
}

TEST(SceneCheck, free_surfaces_are_flat_and_simple_and_holes_run_against_them) {
    Scene scene = sound_scene();
    FreeSurface screen{scene.new_id(),        "screen", {{{1, 1, 1}, {2, 1, 1}, {2, 1, 2}, {1, 1, 2}}, {}},
                       scene.materials[0].id, {},       {}};
    scene.surfaces.push_back(screen);
    EXPECT_TRUE(check_scene(scene).empty());
    scene.surfaces[0].region.outline[2].y = 1.1;
    expect_only(scene, Severity::error, "surfaces[0].outline", "leave their plane");
    scene.surfaces[0] = screen;
    std::swap(scene.surfaces[0].region.outline[1], scene.surfaces[0].region.outline[2]);
    EXPECT_TRUE(has_errors(check_scene(scene)));
    scene.surfaces[0] = screen;
    scene.surfaces[0].region.holes.push_back({{1.2, 1, 1.2}, {1.4, 1, 1.2}, {1.4, 1, 1.4}});
    expect_only(scene, Severity::error, "surfaces[0].holes[0]", "same way");
    std::reverse(scene.surfaces[0].region.holes[0].begin(), scene.surfaces[0].region.holes[0].end());
    EXPECT_TRUE(check_scene(scene).empty());
    scene.surfaces[0].region.outline.resize(2);
    expect_only(scene, Severity::error, "surfaces[0].outline", "at least 3");
}

TEST(SceneCheck, dimming_beyond_full_output_is_an_error) {
    Scene scene = sound_scene();
    scene.luminaires[0].dimming = 1.5;
    expect_only(scene, Severity::error, "luminaires[0].dimming", "allowed are 0 to 1");
}

TEST(SceneCheck, openings_distributions_and_outputs_that_do_not_go_together_are_errors) {
    Scene scene = sound_scene();
    scene.luminaires[0].distribution = CosinePower{2.0};
    expect_only(scene, Severity::error, "luminaires[0].distribution", "not with a polygon");
    scene = sound_scene();
    scene.luminaires[0].opening = LineOpening{};
    scene.luminaires[0].output = Luminance{1000.0};
    expect_only(scene, Severity::error, "luminaires[0].luminance_cd_m2", "not with a line");
    scene = sound_scene();
    scene.luminaires[0].output = AsMeasured{};
    expect_only(scene, Severity::error, "luminaires[0].as_measured", "no photometry");
    scene = sound_scene();
    scene.luminaires[0].opening = MeasuredOpening{};
    expect_only(scene, Severity::error, "luminaires[0].distribution", "needs a measured distribution");
    scene = sound_scene();
    scene.luminaires[0].distribution = Measured{{99}};
    expect_only(scene, Severity::error, "luminaires[0].distribution.photometry", "no such photometry");
    scene = sound_scene();
    scene.luminaires[0].output = LuminousFlux{-1.0};
    expect_only(scene, Severity::error, "luminaires[0].flux_lm", "negative");
    scene = sound_scene();
    scene.luminaires[0].opening = LineOpening{{0, 0, 0}, {0, 0, 0}};
    expect_only(scene, Severity::error, "luminaires[0].opening.to", "no length");
}

TEST(SceneCheck, a_photometric_table_with_a_missing_value_is_an_error) {
    Scene scene = sound_scene();
    Photometry photometry;
    photometry.id = scene.new_id();
    photometry.name = "louvre";
    photometry.horizontal_deg = {0};
    photometry.vertical_deg = {0, 45, 90};
    photometry.candela = {100, 50};
    scene.photometries.push_back(photometry);
    expect_only(scene, Severity::error, "photometries[0].candela", "found 2 intensities, 3 belong");
    scene.photometries[0].candela = {100, -50, 0};
    expect_only(scene, Severity::error, "photometries[0].candela", "0 or more");
    scene.photometries[0].candela = {100, 50, 0};
    scene.photometries[0].vertical_deg = {0, 45, 45};
    expect_only(scene, Severity::error, "photometries[0].vertical_deg", "increase");
}

TEST(SceneCheck, a_luminaire_above_the_ceiling_is_warned_about_with_its_distance) {
    Scene scene = sound_scene();
    scene.luminaires[0].position.z = 2.9;
    expect_only(scene, Severity::warning, "luminaires[0].position", "0.1 m out of the room");
}

TEST(SceneCheck, a_luminaire_inside_furniture_is_warned_about) {
    Scene scene = sound_scene();
    scene.luminaires[0].position = {2, 1, 0.5};
    expect_only(scene, Severity::warning, "luminaires[0].position", "inside \"desk\"");
}

TEST(SceneCheck, a_panel_that_shines_at_the_ceiling_above_it_is_warned_about) {
    Scene scene = sound_scene();
    scene.luminaires[0].position.z = 2.79;
    EXPECT_TRUE(check_scene(scene).empty());
    scene.luminaires[0].roll = std::numbers::pi;
    expect_only(scene, Severity::warning, "luminaires[0].opening.outline", "reverse");
}

TEST(SceneCheck, a_luminaire_flush_with_the_ceiling_is_fine) {
    Scene scene = sound_scene();
    scene.luminaires[0].position.z = 2.8;
    EXPECT_TRUE(check_scene(scene).empty());
}

TEST(SceneCheck, furniture_that_touches_a_wall_is_fine_and_through_it_is_warned_about) {
    Scene scene = sound_scene();
    scene.furniture[0].position.x = 3.5;
    EXPECT_TRUE(check_scene(scene).empty());
    scene.furniture[0].position.x = 3.6;
    expect_only(scene, Severity::warning, "furniture[0].position", "0.1 m out of the room");
}

TEST(SceneCheck, furniture_in_the_notch_of_an_l_shaped_room_is_outside) {
    Scene scene = sound_scene();
    scene.room->plan = {{0, 0}, {4, 0}, {4, 3}, {2.8, 3}, {2.8, 2}, {0, 2}};
    scene.room->wall_materials.assign(6, scene.materials[0].id);
    scene.grids.clear();
    scene.points.clear();
    EXPECT_TRUE(check_scene(scene).empty());
    scene.furniture[0].position = {1, 2.5, 0};
    expect_only(scene, Severity::warning, "furniture[0].position", "out of the room");
}

TEST(SceneCheck, touching_solids_are_fine_and_overlapping_ones_are_warned_about_with_their_depth) {
    Scene scene = sound_scene();
    Furniture second = scene.furniture[0];
    second.id = scene.new_id();
    second.name = "cabinet";
    second.position.x = 3.0;
    scene.furniture.push_back(second);
    EXPECT_TRUE(check_scene(scene).empty());
    scene.furniture[1].position.x = 2.99;
    expect_only(scene, Severity::warning, "furniture[1].position", "0.01 m deep");
    scene.furniture[1].position = {3.2, 1.6, 0};
    scene.furniture[1].rotation = 0.7;  // corner to corner: only a slanted plane parts them
    EXPECT_TRUE(check_scene(scene).empty());
}

TEST(SceneCheck, a_grid_without_area_or_with_too_many_points_is_an_error) {
    Scene scene = sound_scene();
    scene.grids[0].across = {2, 0, 0};
    expect_only(scene, Severity::error, "grids[0].across", "no area");
    scene = sound_scene();
    scene.grids[0].spacing = 0.001;
    expect_only(scene, Severity::error, "grids[0].spacing", "at most a million");
    scene = sound_scene();
    scene.grids[0].spacing = 0.0;
    expect_only(scene, Severity::error, "grids[0].spacing", "greater than 0");
}

TEST(SceneCheck, a_grid_that_looks_into_the_wall_it_lies_on_is_warned_about) {
    Scene scene = sound_scene();
    scene.grids[0] = {scene.grids[0].id, "board", {0, 3, 1}, {4, 0, 0}, {0, 0, 1}, 0.5, {}};
    EXPECT_TRUE(check_scene(scene).empty());
    scene.grids[0].corner.x = 4;
    scene.grids[0].along.x = -4;
    expect_only(scene, Severity::warning, "grids[0].across", "reverse");
}

TEST(SceneCheck, a_normal_that_is_not_of_length_one_is_an_error) {
    Scene scene = sound_scene();
    scene.points[0].normal = {0, 1, 1};
    expect_only(scene, Severity::error, "points[0].normal", "1.41421 long");
}

TEST(SceneCheck, a_camera_that_looks_at_itself_is_an_error) {
    Scene scene = sound_scene();
    scene.views[0].target = scene.views[0].eye;
    expect_only(scene, Severity::error, "views[0].target", "same place");
    scene = sound_scene();
    scene.views[0].field_of_view = 4.0;
    expect_only(scene, Severity::error, "views[0].field_of_view_deg", "229.183 degrees");
}

TEST(SceneCheck, all_faults_are_reported_not_the_first_alone) {
    Scene scene = sound_scene();
    scene.maintenance_factor = 2.0;
    scene.materials[0].reflectance = -0.1;
    scene.luminaires[0].dimming = -1.0;
    scene.views[0].target = scene.views[0].eye;
    EXPECT_EQ(check_scene(scene).size(), 4U);
}

}  // namespace
}  // namespace hanei
