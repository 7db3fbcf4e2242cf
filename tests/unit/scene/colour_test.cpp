#include "engine/scene/colour.h"

#include <algorithm>
#include <gtest/gtest.h>

namespace hanei {
namespace {

constexpr Vec3 white{1.0};

/// A room of one material with a lamp a temperature.
Scene room_with_lamps(std::initializer_list<double> temperatures) {
    Scene scene;
    scene.materials.push_back({scene.new_id(), "paint", 0.5, {}});
    Room room;
    room.id = scene.new_id();
    room.plan = {{0, 0}, {4, 0}, {4, 3}, {0, 3}};
    room.floor_material = room.ceiling_material = scene.materials[0].id;
    room.wall_materials.assign(4, scene.materials[0].id);
    scene.room = room;
    for (const double kelvin : temperatures) {
        Luminaire lamp;
        lamp.id = scene.new_id();
        lamp.colour_temperature = kelvin;
        scene.luminaires.push_back(lamp);
    }
    return scene;
}

void expect_near(const Vec3& found, const Vec3& expected, double tolerance) {
    for (int b = 0; b < colour_bands; ++b) EXPECT_NEAR(found[b], expected[b], tolerance) << "band " << b;
}

TEST(Colour, white_of_any_brightness_has_that_luminance) {
    EXPECT_EQ(luminance(white), 1.0);
    EXPECT_NEAR(luminance(Vec3(500.0)), 500.0, 1e-12 * 500.0);  // a few roundings
}

TEST(Colour, a_material_without_tint_has_its_reflectance_in_every_band_to_the_bit) {
    const Material grey{{1}, "grey", 1.0 / 3.0, {}};
    for (const double band : band_reflectances(grey)) EXPECT_EQ(band, 1.0 / 3.0);
}

TEST(Colour, the_bands_of_a_tinted_material_keep_its_luminous_reflectance) {
    Material red{{1}, "red", 0.2, {}};
    red.tint = tint_from_srgb({0.8, 0.1, 0.1}, red.reflectance);
    const auto [r, g, b] = band_reflectances(red);
    EXPECT_NEAR(luminance({r, g, b}), 0.2, 1e-15);
    EXPECT_GT(r, 10.0 * g);
    EXPECT_EQ(g, b);
}

TEST(Colour, a_colour_chosen_on_screen_comes_back_when_its_reflectance_is_its_own) {
    const Vec3 chosen{0.75, 0.4, 0.2};
    Material brick{{1}, "brick", luminance({0.522522, 0.132868, 0.033105}), {}};  // decoded (IEC 61966-2-1)
    brick.tint = tint_from_srgb(chosen, brick.reflectance);
    expect_near(srgb_from(brick), chosen, 1e-5);  // six digits of the figures above
}

TEST(Colour, greys_and_black_have_no_tint) {
    for (const double grey : {0.0, 0.123, 0.5, 1.0}) EXPECT_EQ(tint_from_srgb(Vec3(grey), 0.5), white);
}

TEST(Colour, a_bright_surface_can_only_be_pale) {
    for (const double reflectance : {0.3, 0.5, 0.8, 0.94}) {
        Material blue{{1}, "blue", reflectance, {}};
        blue.tint = tint_from_srgb({0.0, 0.0, 1.0}, reflectance);
        const auto bands = band_reflectances(blue);
        EXPECT_NEAR(luminance({bands[0], bands[1], bands[2]}), reflectance, 1e-14);
        EXPECT_NEAR(bands[2], most_of_a_chosen_band, 1e-14) << "as saturated as it can be";
        EXPECT_EQ(possible_tint(blue.tint, 0.01), blue.tint);
    }
    for (const double reflectance : {0.95, 0.99, 1.0}) EXPECT_EQ(tint_from_srgb({0.0, 0.0, 1.0}, reflectance), white);
    EXPECT_EQ(possible_tint(white, 1.0), white);
}

TEST(Colour, daylight_of_6504_kelvin_is_the_white_of_srgb) {
    expect_near(light_of_temperature(6504.0), white, 1e-3);  // CIE 15 gives x 0.3127 in four digits
}

TEST(Colour, an_incandescent_lamp_has_the_colour_of_illuminant_a) {
    // CIE 15: x 0.44758, y 0.40745; by the matrix of IEC 61966-2-1
    expect_near(light_of_temperature(2856.0), {1.84365, 0.82645, 0.23493}, 5e-3);  // Krystek: 2e-4 in u and v
}

TEST(Colour, every_temperature_has_unit_luminance_no_negative_band_and_no_jump) {
    Vec3 before = light_of_temperature(lowest_colour_temperature);
    for (double kelvin = lowest_colour_temperature; kelvin <= highest_colour_temperature; kelvin += 5.0) {
        const Vec3 light = light_of_temperature(kelvin);
        EXPECT_NEAR(luminance(light), 1.0, 1e-14);
        EXPECT_GE(std::min({light.x, light.y, light.z}), 0.0);
        EXPECT_LT(glm::length(light - before), 0.02) << kelvin;                   // red at 1000 K: 0.015 in 5 K
        EXPECT_LE(light.x, before.x + 1e-3) << kelvin << ": hotter is less red";  // slack: CIE's two formulas at 7000 K
        before = light;
    }
    EXPECT_EQ(light_of_temperature(1.0), light_of_temperature(lowest_colour_temperature));
    EXPECT_EQ(light_of_temperature(1e9), light_of_temperature(highest_colour_temperature));
}

TEST(Colour, lamps_of_one_temperature_shine_white_and_need_one_band) {
    const Scene scene = room_with_lamps({3000.0, 3000.0, 3000.0});
    EXPECT_TRUE(is_neutral(scene));
    EXPECT_EQ(band_output(scene.luminaires[1], scene), white);
    EXPECT_TRUE(is_neutral(room_with_lamps({})));
    EXPECT_TRUE(is_neutral(Scene{}));
    EXPECT_EQ(reference_white(Scene{}), white);
}

TEST(Colour, a_warm_lamp_among_neutral_ones_is_warm_and_they_stay_white) {
    const Scene scene = room_with_lamps({0.0, 2700.0, 0.0});
    EXPECT_FALSE(is_neutral(scene));
    EXPECT_EQ(band_output(scene.luminaires[0], scene), white);
    expect_near(band_output(scene.luminaires[1], scene), light_of_temperature(2700.0), 1e-15);
}

TEST(Colour, between_a_warm_and_a_cold_lamp_lies_the_white) {
    const Scene scene = room_with_lamps({2700.0, 6500.0});
    const Vec3 warm = band_output(scene.luminaires[0], scene);
    const Vec3 cold = band_output(scene.luminaires[1], scene);
    EXPECT_GT(warm.x, 1.1);
    EXPECT_LT(warm.z, 0.9);
    EXPECT_LT(cold.x, 0.9);
    EXPECT_GT(cold.z, 1.1);
    EXPECT_NEAR(luminance(warm), 1.0, 1e-15);
    EXPECT_NEAR(luminance(cold), 1.0, 1e-15);
}

TEST(Colour, candles_beside_embers_divide_by_no_missing_blue) {
    const Scene scene = room_with_lamps({1000.0, 1500.0});
    for (const Luminaire& lamp : scene.luminaires) {
        const Vec3 light = band_output(lamp, scene);
        EXPECT_NEAR(luminance(light), 1.0, 1e-14);
        EXPECT_GE(std::min({light.x, light.y, light.z}), 0.0);
    }
}

TEST(Colour, a_surface_that_emits_by_itself_is_a_neutral_light) {
    Scene scene = room_with_lamps({3000.0});
    FreeSurface screen;
    screen.material = scene.materials[0].id;
    scene.surfaces.push_back(screen);
    EXPECT_TRUE(is_neutral(scene));
    scene.surfaces[0].own_exitance = {100.0};
    EXPECT_FALSE(is_neutral(scene));
    EXPECT_EQ(reference_white(scene), white);
    expect_near(band_output(scene.luminaires[0], scene), light_of_temperature(3000.0), 1e-15);
}

TEST(Colour, only_a_colour_that_is_seen_and_reflects_makes_a_scene_coloured) {
    Scene scene = room_with_lamps({0.0});
    scene.materials.push_back({scene.new_id(), "red", 0.2, {}});
    const ObjectId red = scene.materials[1].id;
    scene.materials[1].tint = tint_from_srgb({0.8, 0.1, 0.1}, 0.2);
    EXPECT_TRUE(is_neutral(scene)) << "nothing is covered with it";
    scene.room->wall_materials[2] = red;
    EXPECT_FALSE(is_neutral(scene));
    EXPECT_EQ(coloured_materials(scene), std::vector<ObjectId>{red});
    scene.materials[1].reflectance = 0.0;
    EXPECT_TRUE(is_neutral(scene)) << "black has no colour";
}

TEST(Colour, a_file_states_a_temperature_in_plain_figures_or_not_at_all) {
    Photometry photometry;
    EXPECT_EQ(stated_colour_temperature(photometry), std::nullopt) << "no lamps";
    photometry.lamp_sets.resize(2);
    photometry.lamp_sets[1].colour = "6500";
    const auto stated = [&](const char* text) {
        photometry.lamp_sets[0].colour = text;
        return stated_colour_temperature(photometry);
    };
    for (const char* text : {"3000", "3000K", " 3000 K ", "3000.0", "3e3 k"}) EXPECT_EQ(stated(text), 3000.0) << text;
    for (const char* text :
         {"", " ", "nw", "830", "0", "0.5", "3000-4000 K", "3000 K, 90", "-3000", "nan", "inf", "1e99", "K", "30000"})
        EXPECT_EQ(stated(text), std::nullopt) << text;
    photometry.lamp_set = 1;
    EXPECT_EQ(stated("3000"), 6500.0) << "of the lamps in use";
    photometry.keywords = {{std::string(colour_temperature_keyword), "2700 K"}};
    EXPECT_EQ(stated("3000"), 2700.0) << "the container goes before the file in it";
    photometry.lamp_set = 7;
    photometry.keywords.clear();
    EXPECT_EQ(stated("3000"), std::nullopt);
}

TEST(Colour, a_tint_and_a_colour_temperature_make_another_scene) {
    const Scene before = room_with_lamps({0.0});
    Scene after = before;
    after.materials[0].tint = {1.05, 1.0, 0.85281};
    EXPECT_NE(before, after);
    after = before;
    after.luminaires[0].colour_temperature = 3000.0;
    EXPECT_NE(before, after) << "so that it is a step of the history";
}

}  // namespace
}  // namespace hanei
