#include "ui/panels/hanging.h"

#include <gtest/gtest.h>

namespace hanei {
namespace {

Photometry downlight(double extent) {
    Photometry photometry;
    photometry.name = "Downlight";
    photometry.horizontal_deg = {0.0};
    photometry.symmetry = PhotometricSymmetry::rotational;
    photometry.vertical_deg = {0.0, 90.0};
    photometry.candela = {100.0, 0.0};
    photometry.opening = {OpeningShape::circle, extent, extent, 0.0};
    return photometry;
}

Ray down_at(double x, double y) { return {{x, y, 9.0}, {0.0, 0.0, -1.0}}; }

TEST(APlaceInThePlan, is_below_the_pointer_and_on_the_raster) {
    const Vec2 place = place_in_plan(empty_room(), down_at(1.234, 2.345), 0.1);
    EXPECT_NEAR(place.x, 1.2, 1e-12);  // rounding of the raster
    EXPECT_NEAR(place.y, 2.3, 1e-12);
    EXPECT_EQ(place_in_plan(empty_room(), down_at(1.234, 2.345), 0.0), Vec2(1.234, 2.345));
}

TEST(APlaceInThePlan, keeps_off_the_wall_that_is_pointed_at) {
    const Ray at_wall{{3.0, 2.0, 1.5}, {1.0, 0.0, 0.0}};
    EXPECT_NEAR(place_in_plan(empty_room(), at_wall, 0.1).x, 5.7, 1e-12);  // 0.3 m off the wall at 6 m
}

TEST(APlaceInThePlan, is_the_middle_of_the_room_when_nothing_is_pointed_at) {
    EXPECT_EQ(place_in_plan(empty_room(), {}, 0.1), Vec2(3.0, 2.0));
    const Ray at_the_sky{{3.0, 2.0, 9.0}, {0.0, 0.0, 1.0}};
    EXPECT_EQ(place_in_plan(empty_room(), at_the_sky, 0.1), Vec2(3.0, 2.0));
    EXPECT_EQ(place_in_plan(Scene{}, down_at(1.0, 1.0), 0.1), Vec2(3.0, 2.0));
}

TEST(LuminairesOfFiles, hang_in_a_row_within_the_room) {
    const Added added = with_measured_luminaires(empty_room(), {downlight(0.2), downlight(0.4)}, {5.8, 1.0});
    const auto& hung = added.scene.luminaires;
    ASSERT_EQ(hung.size(), 2U);
    EXPECT_EQ(added.object, hung[1].id);
    EXPECT_NEAR(hung[1].position.x - hung[0].position.x, 0.6, 1e-12);  // 0.1 + 0.3 + 0.2
    EXPECT_NEAR(hung[1].position.x, 5.8, 1e-12);                       // its side touches the wall
    EXPECT_EQ(hung[0].position.z, 2.75);
    EXPECT_EQ(added.scene.photometries.size(), 2U);
}

TEST(LuminairesOfFiles, shine_in_the_colour_temperature_their_file_states) {
    Photometry warm = downlight(0.2);
    warm.lamp_sets.resize(1);
    warm.lamp_sets[0].colour = "2700 K";
    const Added added = with_measured_luminaires(empty_room(), {warm, downlight(0.4)}, {3.0, 1.0});
    EXPECT_EQ(added.scene.luminaires[0].colour_temperature, 2700.0);
    EXPECT_EQ(added.scene.luminaires[1].colour_temperature, 0.0);
}

TEST(LuminairesOfFiles, share_the_photometry_of_one_file) {
    const Added added = with_measured_luminaires(empty_room(), {downlight(0.2), downlight(0.2)}, {3.0, 1.0});
    EXPECT_EQ(added.scene.photometries.size(), 1U);
    EXPECT_EQ(added.scene.luminaires[0].distribution, added.scene.luminaires[1].distribution);
}

}  // namespace
}  // namespace hanei
