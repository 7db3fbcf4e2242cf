#include "engine/edit/hanging.h"

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
