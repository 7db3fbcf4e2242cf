#include "ui/view/colour_scale.h"

#include "room_by_hand.h"
#include "ui/view/isolux_labels.h"

#include <cmath>
#include <gtest/gtest.h>

namespace hanei {
namespace {

double linear(float encoded) {
    const double v = static_cast<double>(encoded);
    return v <= 0.04045 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4);
}

/// CIE L* of an sRGB colour.
double lightness(const glm::vec3& rgb) {
    const double y = 0.2126 * linear(rgb.x) + 0.7152 * linear(rgb.y) + 0.0722 * linear(rgb.z);
    return y > 216.0 / 24389.0 ? 116.0 * std::cbrt(y) - 16.0 : y * 24389.0 / 27.0;
}

TEST(ColourScale, grows_lighter_with_every_entry) {
    const auto& table = colour_table();
    for (std::size_t k = 1; k < table.size(); ++k) EXPECT_GT(lightness(table[k]), lightness(table[k - 1])) << k;
    EXPECT_LT(lightness(table.front()), 15.0);
    EXPECT_GT(lightness(table.back()), 90.0);
}

TEST(ColourScale, grows_lighter_evenly) {
    const auto& table = colour_table();
    const double whole = lightness(table.back()) - lightness(table.front());
    for (std::size_t k = 0; k + 32 < table.size(); k += 16) {
        const double step = (lightness(table[k + 32]) - lightness(table[k])) / whole;
        // An eighth of the table is an eighth of the lightness, give or take what hue and chroma
        // contribute to the path's length.
        EXPECT_NEAR(step, 32.0 / 255.0, 0.06) << k;
    }
}

TEST(ColourScale, marks_figures_beyond_its_ends_with_colours_of_their_own) {
    const auto& table = colour_table();
    EXPECT_LT(lightness(colour_below), lightness(table.front()));
    EXPECT_GT(lightness(colour_above), lightness(table.back()));
    ViewOptions view;
    for (const ColourSteps steps : {ColourSteps::logarithmic, ColourSteps::linear, ColourSteps::standard_steps}) {
        view.steps = steps;
        EXPECT_TRUE(colour_of(view.range.low * 0.99, view) == colour_below);
        EXPECT_TRUE(colour_of(view.range.high * 1.01, view) == colour_above);
        EXPECT_TRUE(colour_of(view.range.low, view) == table.front());
        EXPECT_LT(glm::length(colour_of(view.range.high, view) - table.back()), 1e-5F);
        EXPECT_TRUE(colour_of(std::nan(""), view) == colour_below) << "a figure that is none is not drawn bright";
    }
}

TEST(ColourScale, places_equal_ratios_equally_far_apart_on_the_logarithmic_scale) {
    ViewOptions view;
    view.range = {10.0, 1000.0};
    EXPECT_NEAR(scale_position(100.0, view), 0.5, 1e-12);
    EXPECT_NEAR(scale_position(31.6227766, view), 0.25, 1e-9);  // 10^1.5
    view.steps = ColourSteps::linear;
    EXPECT_NEAR(scale_position(505.0, view), 0.5, 1e-12);
}

TEST(ColourScale, keeps_one_colour_between_two_steps) {
    ViewOptions view;
    view.steps = ColourSteps::standard_steps;
    view.range = {20.0, 750.0};
    EXPECT_TRUE(colour_of(301.0, view) == colour_of(499.0, view));
    EXPECT_FALSE(colour_of(499.0, view) == colour_of(501.0, view));
    EXPECT_FALSE(colour_of(299.0, view) == colour_of(301.0, view));
}

TEST(ColourScale, legend_heights_and_figures_are_inverse) {
    ViewOptions view;
    view.range = {15.0, 2000.0};
    for (const ColourSteps steps : {ColourSteps::logarithmic, ColourSteps::linear, ColourSteps::standard_steps}) {
        view.steps = steps;
        for (const double height : {0.01, 0.2, 0.55, 0.9}) {
            EXPECT_NEAR(legend_position(lux_at(height, view), view), height, 1e-9);
        }
    }
}

TEST(StandardSteps, are_those_of_the_norm_within_the_range) {
    const std::vector<double> expected{20, 30, 50, 75, 100, 150, 200, 300, 500, 750, 1000};
    EXPECT_EQ(standard_steps({20.0, 1000.0}), expected);
    EXPECT_EQ(standard_steps({16.0, 1400.0}), expected);
}

TEST(StandardSteps, go_on_below_one_lux_and_survive_odd_ranges) {
    const std::vector<double> expected{0.2, 0.3, 0.5, 0.75, 1, 1.5};
    EXPECT_EQ(standard_steps({0.2, 1.5}), expected);
    EXPECT_TRUE(standard_steps({100.0, 10.0}).empty());
    EXPECT_TRUE(standard_steps({std::nan(""), 10.0}).size() < 100);
    EXPECT_GT(standard_steps({0.0, 100.0}).size(), 5U);
    EXPECT_LT(standard_steps({0.0, 100.0}).size(), 60U);
}

TEST(SuggestedRange, encloses_what_the_room_shows_between_steps) {
    const auto solution = test::solution_by_hand(test::furnished_room(), [](const Vec3& place, const Vec3&) {
        return test::Light{100.0 * place.x, 40.0, 0.0};  // 40 to 640 lx
    });
    const LuxRange range = suggested_range(*solution);
    EXPECT_EQ(range.high, 750.0);
    EXPECT_EQ(range.low, 30.0);
}

TEST(SuggestedRange, is_not_led_astray_by_darkness_or_by_an_even_room) {
    const auto dark = test::single_cell({0.0F, 0.0F, 0.0F, 0.0F});
    EXPECT_TRUE(suggested_range(*dark) == LuxRange{});
    const auto even = test::single_cell({400.0F, 400.0F, 400.0F, 400.0F});
    const LuxRange range = suggested_range(*even);
    EXPECT_EQ(range.high, 500.0);
    EXPECT_EQ(range.low, 100.0);
}

TEST(LuxText, writes_round_figures_without_noise) {
    EXPECT_EQ(lux_text(0.75), "0.75");
    EXPECT_EQ(lux_text(7.5), "7.5");
    EXPECT_EQ(lux_text(300.0), "300");
    EXPECT_EQ(lux_text(1500.0), "1500");
    EXPECT_EQ(lux_text(20000.0), "20000");
}

}  // namespace
}  // namespace hanei
