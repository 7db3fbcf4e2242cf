#include "engine/plan/plan.h"

#include "engine/plan/light_bounds.h"
#include "engine/plan/places.h"
#include "tests/unit/mesh/sample_scenes.h"

#include <cmath>
#include <gtest/gtest.h>

namespace hanei {
namespace {

void add_point_luminaire(Scene& scene, Vec3 position, double flux = 1000.0) {
    Luminaire lamp;
    lamp.id = scene.new_id();
    lamp.position = position;
    lamp.output = LuminousFlux{flux};
    scene.luminaires.push_back(lamp);
}

void add_panel(Scene& scene, Vec3 position, double flux = 3000.0) {
    add_point_luminaire(scene, position, flux);
    scene.luminaires.back().opening =
        PolygonOpening{{{{-0.6, -0.3, 0}, {-0.6, 0.3, 0}, {0.6, 0.3, 0}, {0.6, -0.3, 0}}, {}}};
}

TEST(Plan, an_empty_convex_room_needs_no_shadow_tests) {
    Scene scene = sample::box_room(6.0, 4.0, 2.8);
    add_panel(scene, {3.0, 2.0, 2.8});
    const EffectsPlan plan = plan_effects(scene, {});
    EXPECT_EQ(plan.row(Effect::occlusion_direct).state, EffectState::not_present);
    EXPECT_EQ(plan.row(Effect::occlusion_patches).state, EffectState::not_present);
    EXPECT_EQ(plan.row(Effect::penumbra).state, EffectState::not_present);
    EXPECT_TRUE(plan.simulates(Effect::interreflection));
    EXPECT_TRUE(plan.simulates(Effect::bounces));
}

TEST(Plan, the_rows_come_in_the_order_of_the_effects_and_give_reasons) {
    Scene scene = sample::computer_room();
    add_panel(scene, {3.0, 2.0, 2.8});
    const EffectsPlan plan = plan_effects(scene, {});
    ASSERT_EQ(plan.effects.size(), 10U);
    for (std::size_t k = 0; k < plan.effects.size(); ++k) {
        EXPECT_EQ(static_cast<std::size_t>(plan.effects[k].effect), k);
        EXPECT_GT(plan.effects[k].why.size(), 20U);
        if (plan.effects[k].effect == Effect::opening_size) continue;  // no luminaire file here
        if (plan.effects[k].effect == Effect::three_bands) continue;   // and no colour
        if (plan.effects[k].effect == Effect::daylight) continue;      // and no sky
        EXPECT_EQ(plan.effects[k].state, EffectState::simulated);
        EXPECT_GT(plan.effects[k].predicted_ms, 0.0);
    }
    EXPECT_EQ(plan.skipped_lux, 0.0);
    EXPECT_EQ(plan.missing, nullptr);
}

TEST(Plan, furniture_re_entrant_walls_and_opaque_panels_ask_for_shadow_tests) {
    Scene furnished = sample::box_room(6.0, 4.0, 2.8);
    sample::add_table(furnished, {3.0, 2.0, 0.0});
    Scene angled = sample::l_room();
    Scene paneled = sample::box_room(6.0, 4.0, 2.8);
    add_panel(paneled, {3.0, 2.0, 2.7});
    paneled.luminaires.back().opaque = true;
    for (Scene* scene : {&furnished, &angled, &paneled}) {
        add_point_luminaire(*scene, {1.0, 1.0, 2.0});
        EXPECT_TRUE(plan_effects(*scene, {}).simulates(Effect::occlusion_direct));
        EXPECT_TRUE(plan_effects(*scene, {}).simulates(Effect::occlusion_patches));
        EXPECT_FALSE(obstacles_of(*scene).empty());
    }
}

TEST(Plan, point_sources_throw_no_penumbra) {
    Scene scene = sample::computer_room();
    add_point_luminaire(scene, {3.0, 2.0, 2.5});
    EXPECT_EQ(plan_effects(scene, {}).row(Effect::penumbra).state, EffectState::not_present);
    add_panel(scene, {3.0, 2.0, 2.5}, 0.0);  // gives no light
    EXPECT_EQ(plan_effects(scene, {}).row(Effect::penumbra).state, EffectState::not_present);
    add_panel(scene, {3.0, 2.0, 2.5});
    EXPECT_TRUE(plan_effects(scene, {}).simulates(Effect::penumbra));
}

TEST(Plan, a_room_without_light_simulates_nothing) {
    const EffectsPlan plan = plan_effects(sample::computer_room(), {});
    for (const PlannedEffect& effect : plan.effects) EXPECT_EQ(effect.state, EffectState::not_present);
}

TEST(Plan, a_black_room_has_no_interreflection_but_a_shining_surface_has) {
    Scene scene = sample::box_room(6.0, 4.0, 2.8, 0.0);
    add_panel(scene, {3.0, 2.0, 2.8});
    EXPECT_EQ(plan_effects(scene, {}).row(Effect::interreflection).state, EffectState::not_present);
    sample::add_surface(scene, {{1, 1, 1}, {2, 1, 1}, {2, 2, 1}, {1, 2, 1}}, 0.0, 100.0);
    EXPECT_TRUE(plan_effects(scene, {}).simulates(Effect::interreflection));
}

TEST(Plan, interreflection_is_skipped_when_its_bound_is_within_the_tolerance) {
    Scene scene = sample::box_room(6.0, 4.0, 2.8, 0.02);
    add_panel(scene, {3.0, 2.0, 2.8}, 720.0);  // 1000 lm/m2
    const double bound = plan_effects(scene, {}).row(Effect::interreflection).bound_lux;
    EXPECT_LE(bound, 0.02 * 1000.0 / 0.98);  // as if the whole hemisphere were the brightest place
    EXPECT_GT(bound, 0.02 * 10.0);
    Settings settings;
    settings.tolerance_lux = bound * 0.999;
    EXPECT_TRUE(plan_effects(scene, settings).simulates(Effect::interreflection));
    settings.tolerance_lux = bound * 1.001;
    const EffectsPlan plan = plan_effects(scene, settings);
    EXPECT_EQ(plan.row(Effect::interreflection).state, EffectState::skipped);
    EXPECT_NEAR(plan.skipped_lux, bound, 1e-9 * bound);  // rounding
    EXPECT_EQ(plan.row(Effect::bounces).state, EffectState::not_present);
    EXPECT_EQ(plan.row(Effect::occlusion_patches).state, EffectState::not_present);
}

TEST(Plan, the_number_of_bounces_follows_the_greatest_reflectance) {
    Scene scene = sample::box_room(6.0, 4.0, 2.8, 0.8);
    add_panel(scene, {3.0, 2.0, 2.8});
    Settings settings;
    settings.accuracy = 0.01;
    const PlannedEffect free = plan_effects(scene, settings).row(Effect::bounces);
    EXPECT_EQ(free.count, 28);  // 0.8^28 / 0.2 < 0.01 <= 0.8^27 / 0.2
    EXPECT_EQ(free.bound_lux, 0.0);
    settings.bounces = 4;
    const PlannedEffect capped = plan_effects(scene, settings).row(Effect::bounces);
    EXPECT_EQ(capped.count, 4);
    const double exitance = 3000.0 / 0.72;
    EXPECT_NEAR(capped.bound_lux, 0.8 * exitance * std::pow(0.8, 4) / 0.2, 1e-9 * exitance);  // rounding
}

TEST(Plan, the_bound_on_direct_light_holds_for_points_and_lines) {
    Scene scene = sample::box_room(6.0, 4.0, 3.0);
    add_point_luminaire(scene, {3.0, 2.0, 1.0}, 4.0 * 3.14159265358979323846);
    EXPECT_NEAR(light_bounds(scene, faces_of(scene)).direct, 1.0, 1e-12);  // 1 cd, 1 m over the floor
    scene.luminaires.back().opening = LineOpening{{-0.5, 0.0, 0.0}, {0.5, 0.0, 0.0}};
    const double normal_intensity = 4.0 / 3.14159265358979323846;
    // an endless line at 1 m gives pi/2 times its intensity a metre
    const double bound = light_bounds(scene, faces_of(scene)).direct;
    EXPECT_GT(bound, normal_intensity * 3.14159265358979323846 / 2.0);
    EXPECT_LT(bound, normal_intensity * 2.1);
}

TEST(Plan, every_name_is_spoken) {
    for (int k = 0; k < 7; ++k) EXPECT_FALSE(name_of(static_cast<Effect>(k)).empty());
    for (int k = 0; k < 3; ++k) EXPECT_FALSE(name_of(static_cast<EffectState>(k)).empty());
    EXPECT_EQ(name_of(Method::paper), "paper");
    EXPECT_EQ(name_of(Method::patch), "patch");
}

TEST(Plan, a_neutral_room_needs_one_band_of_colour) {
    Scene scene = sample::box_room(6.0, 4.0, 2.8);
    add_panel(scene, {3.0, 2.0, 2.8});
    const PlannedEffect row = plan_effects(scene, {}).row(Effect::three_bands);
    EXPECT_EQ(row.state, EffectState::not_present);
    EXPECT_EQ(row.predicted_ms, 0.0);
    EXPECT_NE(row.why.find("one band"), std::string::npos) << row.why;
}

TEST(Plan, a_coloured_wall_asks_for_three_bands_by_name_and_costs_two_products_more) {
    Scene scene = sample::box_room(6.0, 4.0, 2.8);
    add_panel(scene, {3.0, 2.0, 2.8});
    scene.materials.push_back({scene.new_id(), "brick", 0.2, {}});
    scene.materials.back().tint = {2.0, 0.75, 0.534};
    scene.room->wall_materials[1] = scene.materials.back().id;
    const EffectsPlan plan = plan_effects(scene, {});
    const PlannedEffect row = plan.row(Effect::three_bands);
    EXPECT_EQ(row.state, EffectState::simulated);
    EXPECT_EQ(row.why, "Surfaces have a colour (\"brick\").");
    EXPECT_DOUBLE_EQ(row.predicted_ms, 2.0 * plan.row(Effect::bounces).predicted_ms);
    EXPECT_GT(row.bound_lux, 0.0);
}

TEST(Plan, lamps_of_several_colours_ask_for_three_bands) {
    Scene scene = sample::box_room(6.0, 4.0, 2.8);
    for (int k = 0; k < 3; ++k) add_panel(scene, {1.0 + k, 2.0, 2.8});
    for (Luminaire& lamp : scene.luminaires) lamp.colour_temperature = 3000.0;
    EXPECT_FALSE(plan_effects(scene, {}).simulates(Effect::three_bands));
    scene.luminaires[1].colour_temperature = 0.0;
    const PlannedEffect row = plan_effects(scene, {}).row(Effect::three_bands);
    EXPECT_EQ(row.state, EffectState::simulated);
    EXPECT_EQ(row.why, "Light is of several colours (neutral and 3000 K).");
}

TEST(Plan, what_interreflection_may_add_counts_the_band_that_reflects_most) {
    Scene scene = sample::box_room(6.0, 4.0, 2.8);
    add_panel(scene, {3.0, 2.0, 2.8});
    const double grey = light_bounds(scene, faces_of(scene)).reflectance;
    scene.materials[0].tint = {1.6, 0.9, 0.2238};
    EXPECT_DOUBLE_EQ(light_bounds(scene, faces_of(scene)).reflectance, 1.6 * grey);
}

TEST(Plan, measured_openings_say_from_where_on_they_are_points) {
    Scene scene = sample::box_room(6.0, 4.0, 2.8);
    EXPECT_EQ(plan_effects(scene, {}).row(Effect::opening_size).state, EffectState::not_present);
    Photometry spot;
    spot.id = scene.new_id();
    spot.name = "spot";
    spot.symmetry = PhotometricSymmetry::rotational;
    spot.horizontal_deg = {0};
    spot.vertical_deg = {0, 30, 60, 90};
    spot.candela = {500, 400, 100, 0};
    spot.opening = {OpeningShape::circle, 0.1, 0.1, 0};
    scene.photometries = {spot};
    Luminaire luminaire;
    luminaire.id = scene.new_id();
    luminaire.position = {3.0, 2.0, 2.7};
    luminaire.opening = MeasuredOpening{};
    luminaire.distribution = Measured{spot.id};
    luminaire.output = AsMeasured{};
    scene.luminaires = {luminaire};
    const PlannedEffect row = plan_effects(scene, {}).row(Effect::opening_size);
    EXPECT_EQ(row.state, EffectState::simulated);
    EXPECT_NE(row.why.find("spot beyond"), std::string::npos) << row.why;
    scene.luminaires[0].opening = PointOpening{};
    EXPECT_EQ(plan_effects(scene, {}).row(Effect::opening_size).state, EffectState::not_present);
}

}  // namespace
}  // namespace hanei
