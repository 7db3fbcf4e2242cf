#include "engine/report/photometry_figures.h"

#include "engine/report/photometry_report.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <numbers>

namespace hanei {
namespace {

/// I = 1000 cos(gamma) below the horizontal, in steps of a degree.
Photometry cosine_light() {
    Photometry photometry;
    photometry.name = "cosine";
    photometry.symmetry = PhotometricSymmetry::rotational;
    photometry.horizontal_deg = {0.0};
    for (int gamma = 0; gamma <= 90; ++gamma) {
        photometry.vertical_deg.push_back(gamma);
        photometry.candela.push_back(gamma == 90 ? 0.0 : 1000.0 * std::cos(gamma * std::numbers::pi / 180.0));
    }
    photometry.lamps = 1;
    photometry.lamp_lumens = 4000.0;
    photometry.input_watts = 50.0;
    return photometry;
}

TEST(PhotometryFigures, do_not_change_when_the_light_is_turned_against_the_housing) {
    Photometry oblong = cosine_light();
    oblong.symmetry = PhotometricSymmetry::quadrant;
    oblong.horizontal_deg = {0.0, 90.0};
    const std::vector<double> first = oblong.candela;
    for (std::size_t gamma = 0; gamma <= 90; ++gamma)
        oblong.candela.push_back(first[gamma] * (1.0 - static_cast<double>(gamma) / 180.0));
    const PhotometryFigures before = photometry_figures(oblong);
    oblong.quarter_turns = 1;
    const PhotometryFigures turned = photometry_figures(oblong);
    EXPECT_EQ(turned.plane_90.beam->width_deg(), before.plane_90.beam->width_deg());
    EXPECT_LT(turned.plane_90.beam->width_deg(), turned.plane_0.beam->width_deg());
    EXPECT_EQ(turned.symmetry_found, before.symmetry_found);
}

TEST(PhotometryFigures, say_from_where_an_opening_is_a_point) {
    Photometry photometry = cosine_light();
    EXPECT_EQ(*photometry_figures(photometry).point_distance, 0.0);
    photometry.opening = {OpeningShape::rectangle, 0.6, 0.6, 0.0};
    const double far = *photometry_figures(photometry).point_distance;
    EXPECT_GT(far, 2.0 * 0.6);  // the old rule of five sizes asks for 3 m
    photometry.opening = {OpeningShape::rectangle, 1.2, 1.2, 0.0};
    EXPECT_NEAR(*photometry_figures(photometry).point_distance, 2.0 * far, 0.02 * far);  // it scales with the opening
}

TEST(PhotometryFigures, of_a_cosine_light_are_those_of_the_textbook) {
    const PhotometryFigures figures = photometry_figures(cosine_light());
    const double flux = 1000.0 * std::numbers::pi;
    EXPECT_NEAR(figures.flux.value, flux, 0.1);  // steps of a degree: 1 / 12 of a degree squared
    EXPECT_NEAR(*figures.output_ratio, flux / 4000.0, 1e-4);
    EXPECT_NEAR(*figures.efficacy, flux / 50.0, 1e-2);
    EXPECT_NEAR(*figures.downward_share, 1.0, 1e-12);
    EXPECT_NEAR(figures.plane_0.beam->width_deg(), 120.0, 0.01);
    EXPECT_NEAR(figures.plane_90.field->width_deg(), 2.0 * std::acos(0.1) * 180.0 / std::numbers::pi, 0.02);
    EXPECT_FALSE(figures.plane_0.beam->cut);
    EXPECT_EQ(figures.peak.value, 1000.0);
    EXPECT_TRUE(figures.differences.empty());
}

TEST(PhotometryFigures, flux_that_differs_from_the_declared_by_more_than_two_percent_is_told) {
    Photometry light = cosine_light();
    light.lamp_sets = {{1.0, "", 4000.0, "", "", 50.0}, {1.0, "", 1000.0, "", "", 20.0}};
    light.declared_output_ratio = 1000.0 * std::numbers::pi / 4000.0;
    EXPECT_NEAR(*photometry_figures(light).flux_difference, 0.0, 1e-4);
    EXPECT_TRUE(photometry_figures(light).differences.empty());
    light.lamp_set = 1;
    EXPECT_NEAR(*photometry_figures(light).flux_difference, 3.0, 1e-3);
    ASSERT_EQ(photometry_figures(light).differences.size(), 1U);
    EXPECT_EQ(photometry_figures(light).differences[0],
              "The file declares 785 lm; its intensities integrate to 3142 lm, a difference of +300.0 %.");
}

TEST(PhotometryFigures, the_flux_a_file_states_by_a_keyword_is_compared_too) {
    for (const char* key : {"LuminousFlux", "_ABSOLUTELUMENS", "GLDF rated flux"}) {
        Photometry light = cosine_light();
        light.keywords = {{key, "3141.6 lm"}};
        ASSERT_TRUE(photometry_figures(light).flux_difference) << key;
        EXPECT_NEAR(*photometry_figures(light).flux_difference, 0.0, 1e-4) << key;
    }
    EXPECT_FALSE(photometry_figures(cosine_light()).flux_difference);
}

TEST(PhotometryFigures, planes_0_and_360_are_compared_where_both_are_there) {
    Photometry light = cosine_light();
    EXPECT_FALSE(photometry_figures(light).seam_difference);
    const std::vector<double> row = light.candela;
    light.symmetry = PhotometricSymmetry::none;
    light.horizontal_deg = {0.0, 180.0, 360.0};
    light.candela.insert(light.candela.end(), row.begin(), row.end());
    light.candela.insert(light.candela.end(), row.begin(), row.end());
    EXPECT_EQ(*photometry_figures(light).seam_difference, 0.0);
    light.candela.back() = 100.0;
    EXPECT_NEAR(*photometry_figures(light).seam_difference, 0.1, 1e-12);
}

TEST(PhotometryFigures, an_upward_light_is_measured_from_the_zenith) {
    Photometry up = cosine_light();
    for (double& gamma : up.vertical_deg) gamma += 90.0;
    std::reverse(up.candela.begin(), up.candela.end());
    const PhotometryFigures figures = photometry_figures(up);
    EXPECT_TRUE(figures.plane_0.upward);
    EXPECT_NEAR(figures.plane_0.beam->width_deg(), 120.0, 0.01);
    EXPECT_NEAR(*figures.downward_share, 0.0, 1e-12);
}

TEST(PhotometryFigures, a_light_declared_without_symmetry_shows_the_one_it_has) {
    Photometry light = cosine_light();
    const std::vector<double> row = light.candela;
    light.symmetry = PhotometricSymmetry::none;
    light.horizontal_deg = {0.0, 90.0, 180.0, 270.0};
    const double of_plane[] = {1.0, 0.8, 1.0, 0.5};
    light.candela.clear();
    for (const double share : of_plane) {
        for (const double value : row) light.candela.push_back(share * value);
    }
    EXPECT_EQ(photometry_figures(light).symmetry_found, PhotometricSymmetry::plane_90);
}

TEST(PhotometryFigures, a_dark_luminaire_has_no_ratio_and_no_beam) {
    Photometry dark = cosine_light();
    std::fill(dark.candela.begin(), dark.candela.end(), 0.0);
    dark.absolute = true;
    dark.lamp_lumens = 0.0;
    const PhotometryFigures figures = photometry_figures(dark);
    EXPECT_FALSE(figures.output_ratio || figures.downward_share || figures.plane_0.beam);
    EXPECT_NE(photometry_text(dark).find("not available"), std::string::npos);
}

TEST(PhotometryFigures, a_declared_flux_that_is_not_there_is_said_in_a_sentence) {
    Photometry boast = cosine_light();
    boast.lamp_sets = {{1.0, "LED", 4000.0, "", "", 50.0}};
    boast.declared_output_ratio = 1.0;
    ASSERT_EQ(photometry_figures(boast).differences.size(), 1U);
    boast.declared_output_ratio = 0.785;
    EXPECT_TRUE(photometry_figures(boast).differences.empty());
}

TEST(PhotometryReport, json_holds_the_figures_of_the_text) {
    const auto json = nlohmann::json::parse(photometry_json(cosine_light(), "cosine.ies"));
    EXPECT_EQ(json["file"], "cosine.ies");
    EXPECT_NEAR(json["computed"]["flux_lm"].get<double>(), 3141.6, 0.2);
    EXPECT_EQ(json["computed"]["planes"].size(), 2U);
    EXPECT_TRUE(json["declared"]["flux_lm"].is_null());
    EXPECT_NE(photometry_text(cosine_light()).find("3141"), std::string::npos);
}

}  // namespace
}  // namespace hanei
