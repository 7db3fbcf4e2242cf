#include "ui/view/colour_scale.h"

#include <gtest/gtest.h>

namespace hanei {
namespace {

ViewOptions look_at(double low, double high, ColourSteps steps) {
    ViewOptions look;
    look.range = {low, high};
    look.steps = steps;
    return look;
}

TEST(ScaleSteps, of_a_linear_scale_are_round_and_equally_far_apart) {
    EXPECT_EQ(scale_steps(look_at(0.0, 1000.0, ColourSteps::linear)),
              (std::vector<double>{100, 200, 300, 400, 500, 600, 700, 800, 900, 1000}));
    EXPECT_EQ(scale_steps(look_at(120.0, 430.0, ColourSteps::linear)).front(), 150.0);
    EXPECT_TRUE(scale_steps(look_at(5.0, 5.0, ColourSteps::linear)).empty());
}

TEST(ScaleSteps, are_round_in_the_unit_that_is_shown) {
    ViewOptions look = look_at(100.0, 1100.0, ColourSteps::logarithmic);
    look.unit = IlluminanceUnit::foot_candle;
    const std::vector<double> steps = scale_steps(look);
    ASSERT_FALSE(steps.empty());
    EXPECT_NEAR(steps.front() * 0.09290304, 10.0, 1e-9);  // a foot is 0.3048 m
    look.steps = ColourSteps::standard_steps;
    EXPECT_EQ(scale_steps(look).front(), 100.0) << "the standard's steps are in lux";
}

TEST(ScaleSteps, give_way_to_the_users_own_levels_of_isolux_lines) {
    ViewOptions look = look_at(10.0, 1000.0, ColourSteps::logarithmic);
    EXPECT_EQ(isolux_levels(look), scale_steps(look));
    look.isolux_levels = {300.0, 500.0};
    EXPECT_EQ(isolux_levels(look), look.isolux_levels);
}

TEST(ScaleSteps, of_the_project_come_back_as_they_were_kept) {
    for (const char* steps : {"log", "linear", "en"}) {
        const ColourScale kept{20.0, 750.0, steps, true, {100.0, 500.0}, {}};
        ViewOptions look;
        take_scale(look, kept);
        EXPECT_EQ(scale_of(look), kept);
    }
}

TEST(Hatching, tells_below_from_above_by_its_pattern_and_leaves_the_range_alone) {
    ViewOptions look = look_at(10.0, 1000.0, ColourSteps::logarithmic);
    look.marks_clipped = true;
    int below = 0, above = 0;
    for (int x = 0; x < 60; ++x) {
        for (int y = 0; y < 60; ++y) {
            below += colour_of(5.0, look, x, y, 1.0) == stripe_below ? 1 : 0;
            above += colour_of(5000.0, look, x, y, 1.0) == stripe_above ? 1 : 0;
            EXPECT_EQ(colour_of(100.0, look, x, y, 1.0), colour_of(100.0, look));
        }
    }
    EXPECT_GT(below, 3600 / 8);
    EXPECT_GT(above, 3 * below / 2) << "crossed stripes cover more";
    EXPECT_LT(above, 3600 / 2);
    look.marks_clipped = false;
    EXPECT_EQ(colour_of(5.0, look, 0.0, 0.0, 1.0), colour_below);
}

}  // namespace
}  // namespace hanei
