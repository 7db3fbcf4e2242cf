#include "engine/edit/lumen_method.h"

#include "engine/edit/box_balance.h"
#include "tests/unit/edit/luminaire_scenes.h"

#include <gtest/gtest.h>

namespace hanei {
namespace {

TEST(BoxBalance, the_form_factor_of_two_faces_of_a_cube_is_a_fifth) {
    EXPECT_NEAR(parallel_form_factor(1.0, 1.0, 1.0), 0.199825, 1e-6);  // any table of configuration factors
    EXPECT_EQ(parallel_form_factor(2.0, 1.0, 0.0), 1.0);
    EXPECT_EQ(parallel_form_factor(0.0, 1.0, 1.0), 0.0);
}

TEST(BoxBalance, keeps_all_light_of_a_closed_box) {
    // All surfaces of one reflectance and evenly lit: exitances are alike, E / (1 - rho) each, so that a
    // level gets what an infinite plane of that exitance sends.
    const BoxBalance box(5.0, 3.0, {0.0, 0.8, 1.5, 2.0, 3.0});
    BoxBalance::Direct direct{15.0, 15.0, {}};
    for (std::size_t band = 0; band < box.bands(); ++band) direct.bands.push_back(box.band_area(band));
    const double flux = box.reflected_through(0.8, direct, {0.5, 0.5, 0.5});
    EXPECT_NEAR(flux, 15.0 * 0.5 / (1.0 - 0.5), 1e-6);  // exitance 1 through 15 m2
}

TEST(LumenMethod, without_reflection_the_utilization_is_what_falls_straight_on_the_plane) {
    Added lamp = test::hung(test::lobe(1.0));
    for (Material& material : lamp.scene.materials) material.reflectance = 0.0;
    const LumenAnswer answer =
        lumen_method(lamp.scene, lamp.scene.luminaires[0], {500.0, 0.75, 0.5, {Mounting::recessed}});
    EXPECT_EQ(answer.refusal, "");
    EXPECT_DOUBLE_EQ(answer.mean, answer.direct);
    EXPECT_GT(answer.utilization, 0.3);
    EXPECT_LT(answer.utilization, 0.8);
}

TEST(LumenMethod, an_evenly_lit_large_room_gets_the_flux_over_the_area) {
    Added lamp = test::hung(test::lobe(30.0));  // a narrow beam: hardly any reaches the walls
    lamp.scene.room->plan = {{0, 0}, {60, 0}, {60, 60}, {0, 60}};
    for (Material& material : lamp.scene.materials) material.reflectance = 0.0;
    EXPECT_NEAR(utilization_factor(lamp.scene, lamp.scene.luminaires[0], {}), 1.0, 0.01);
}

TEST(LumenMethod, takes_no_fewer_luminaires_than_the_target_needs_and_hardly_more) {
    const Added lamp = test::hung(test::lobe(1.0));  // 3142 lm
    double last = 0.0;
    for (const double target : {50.0, 100.0, 300.0, 500.0, 1000.0}) {
        const LumenAnswer answer = lumen_method(lamp.scene, lamp.scene.luminaires[0], {target});
        EXPECT_EQ(answer.refusal, "");
        EXPECT_GE(answer.mean, 0.99 * target);
        EXPECT_GE(answer.count(), last);
        const double one = answer.mean / answer.count();
        EXPECT_LE(answer.count(), target / one + 4.0) << "rows and columns must come out even";
        EXPECT_NEAR(answer.watts, 30.0 * answer.count(), 1e-9);
        last = answer.count();
    }
}

TEST(LumenMethod, spaces_luminaires_as_square_as_it_can) {
    Added lamp = test::hung(test::lobe(1.0));
    lamp.scene.room->plan = {{0, 0}, {12, 0}, {12, 4}, {0, 4}};
    const LumenAnswer answer = lumen_method(lamp.scene, lamp.scene.luminaires[0], {500.0});
    const double x = 12.0 / answer.columns, y = 4.0 / answer.rows;
    EXPECT_LT(std::max(x, y) / std::min(x, y), 1.6) << answer.columns << " x " << answer.rows;
}

TEST(LumenMethod, brighter_surfaces_and_a_higher_maintenance_need_fewer_luminaires) {
    Added lamp = test::hung(test::lobe(1.0));
    const int usual = lumen_method(lamp.scene, lamp.scene.luminaires[0], {600.0}).count();
    Scene worn = lamp.scene;
    worn.maintenance_factor = 0.6;
    EXPECT_GT(lumen_method(worn, worn.luminaires[0], {600.0}).count(), usual);
    Scene dark = lamp.scene;
    for (Material& material : dark.materials) material.reflectance = 0.0;
    EXPECT_GT(lumen_method(dark, dark.luminaires[0], {600.0}).count(), usual);
}

TEST(LumenMethod, predicts_for_rows_and_columns_that_are_given) {
    const Added lamp = test::hung(test::lobe(1.0));
    LumenWish wish;
    wish.columns = 3;
    wish.rows = 2;
    const LumenAnswer answer = lumen_method(lamp.scene, lamp.scene.luminaires[0], wish);
    EXPECT_EQ(answer.columns, 3);
    EXPECT_EQ(answer.rows, 2);
    EXPECT_NEAR(answer.room_index, 24.0 / (answer.height * 10.0), 1e-9);
    EXPECT_NEAR(answer.spacing_to_height, 2.0 / answer.height, 1e-9);
}

TEST(LumenMethod, says_why_there_is_no_answer) {
    Added lamp = test::hung(test::lobe(1.0));
    const Luminaire luminaire = lamp.scene.luminaires[0];
    const auto refusal = [&](const Scene& scene, const LumenWish& wish) {
        return lumen_method(scene, luminaire, wish).refusal;
    };
    EXPECT_NE(refusal(lamp.scene, {0.0}), "");
    EXPECT_NE(refusal(lamp.scene, {500.0, 2.9}), "");
    EXPECT_NE(refusal(lamp.scene, {500.0, 2.0, 0.5, {Mounting::pendant, 1.5}}), "");
    EXPECT_NE(refusal(lamp.scene, {1e9}), "");
    Scene roomless = lamp.scene;
    roomless.room.reset();
    EXPECT_NE(refusal(roomless, {}), "");
    Scene dark = lamp.scene;
    for (double& candela : dark.photometries[0].candela) candela = 0.0;
    EXPECT_NE(refusal(dark, {}), "");
}

TEST(LumenMethod, the_spacing_criterion_of_a_diffuse_opening_is_that_of_tables) {
    const Scene panel = with_panel_luminaire(empty_room()).scene;
    // 2 cos^4 = 1 at 32.8 degrees: 1.29 times the height
    EXPECT_NEAR(spacing_criterion(panel, panel.luminaires[0]), 2.0 * std::tan(std::acos(std::pow(0.5, 0.25))), 0.011);
}

}  // namespace
}  // namespace hanei
