#include "ui/panels/photometry_curves.h"

#include "engine/scene/intensity.h"

#include <algorithm>
#include <gtest/gtest.h>

namespace hanei {
namespace {

/// 100 cd along plane 0, 40 cd along plane 90, nothing above the horizontal.
Photometry batwing() {
    Photometry photometry;
    photometry.symmetry = PhotometricSymmetry::quadrant;
    photometry.horizontal_deg = {0.0, 45.0, 90.0};
    photometry.vertical_deg = {0.0, 30.0, 31.25, 90.0};
    photometry.candela = {50.0, 90.0, 100.0, 0.0, 50.0, 60.0, 70.0, 0.0, 50.0, 45.0, 40.0, 0.0};
    photometry.lamp_lumens = 500.0;
    return photometry;
}

double greatest(const std::vector<CurvePoint>& curve) {
    return std::max_element(curve.begin(), curve.end(),
                            [](const CurvePoint& a, const CurvePoint& b) { return a.candela < b.candela; })
        ->candela;
}

TEST(ACurve, passes_through_every_angle_of_the_file) {
    const auto curve = plane_curve(batwing(), 0.0);
    EXPECT_EQ(greatest(curve), 100.0);  // at 31.25 degrees, between the half degrees
    EXPECT_EQ(curve.front().gamma_deg, -180.0);
    EXPECT_EQ(curve.back().gamma_deg, 180.0);
    EXPECT_TRUE(std::is_sorted(curve.begin(), curve.end(),
                               [](const CurvePoint& a, const CurvePoint& b) { return a.gamma_deg < b.gamma_deg; }));
}

TEST(ACurve, shows_the_opposite_half_plane_at_negative_angles) {
    Photometry lopsided = batwing();
    lopsided.symmetry = PhotometricSymmetry::plane_0;
    lopsided.horizontal_deg = {0.0, 90.0, 180.0};
    EXPECT_NEAR(candela_at(lopsided, 0.0, 30.0), 90.0, 1e-9);  // rounding of the direction
    EXPECT_NEAR(candela_at(lopsided, 0.0, -30.0), 45.0, 1e-9);
    EXPECT_NEAR(candela_at(lopsided, 90.0, -30.0), 60.0, 1e-9);
}

TEST(ACurve, follows_the_quarter_turns_of_the_luminaire) {
    Photometry turned = batwing();
    turned.quarter_turns = 1;
    EXPECT_NEAR(candela_at(turned, 90.0, 31.25), 100.0, 1e-9);  // rounding of the direction
    EXPECT_NEAR(candela_at(turned, 0.0, 31.25), 40.0, 1e-9);
}

TEST(ACurve, says_whether_there_is_light_above_the_horizontal) {
    Photometry photometry = batwing();
    EXPECT_FALSE(shines_upward(plane_curve(photometry, 0.0), 100.0));
    photometry.vertical_deg.back() = 170.0;
    EXPECT_TRUE(shines_upward(plane_curve(photometry, 0.0), 100.0));
}

TEST(OfferedPlanes, are_those_of_the_file_with_its_symmetry_unfolded) {
    EXPECT_EQ(offered_planes(batwing()), (std::vector<double>{0.0, 45.0, 90.0, 135.0}));
    Photometry round = batwing();
    round.symmetry = PhotometricSymmetry::rotational;
    EXPECT_EQ(offered_planes(round), std::vector<double>{0.0});
    Photometry floodlight = batwing();
    floodlight.type = PhotometricType::B;
    EXPECT_EQ(offered_planes(floodlight).size(), 12U);
}

TEST(Rings, are_three_to_seven_with_round_steps) {
    for (double peak = 1e-3; peak < 1e6; peak *= 1.07) {
        const double step = ring_step(peak);
        EXPECT_GE(peak / step, 3.0 * (1.0 - 1e-9)) << peak;  // 1e-9: rounding of the steps
        EXPECT_LE(peak / step, 7.5) << peak;
    }
    EXPECT_DOUBLE_EQ(ring_step(1885.0), 500.0);
    EXPECT_DOUBLE_EQ(ring_step(6.9), 1.0);
    EXPECT_EQ(ring_step(0.0), 1.0);
}

TEST(CandelaPerKilolumen, refer_to_the_lamps_or_to_an_absolute_luminaire) {
    Photometry photometry = batwing();
    EXPECT_DOUBLE_EQ(per_kilolumen(photometry), 2.0);
    photometry.absolute = true;
    EXPECT_DOUBLE_EQ(per_kilolumen(photometry), 1000.0 / luminous_flux(photometry).value);
    photometry.candela.assign(photometry.candela.size(), 0.0);
    EXPECT_EQ(per_kilolumen(photometry), 0.0);
}

TEST(APolarFrame, has_straight_down_below_and_finds_its_angles_again) {
    const PolarFrame frame{{100.0, 50.0}, 80.0, 2000.0};
    EXPECT_EQ(frame.at(0.0, 2000.0), Vec2(100.0, 130.0));
    EXPECT_NEAR(frame.at(90.0, 1000.0).x, 140.0, 1e-12);  // rounding of the sine
    for (const double gamma : {-179.0, -90.0, -12.5, 0.0, 45.0, 135.0}) {
        EXPECT_NEAR(frame.gamma_deg(frame.at(gamma, 700.0)), gamma, 1e-9);  // rounding of the arc tangent
    }
    EXPECT_EQ(frame.gamma_deg(frame.centre), 0.0);
}

}  // namespace
}  // namespace hanei
