#include "ui/panels/project_scale.h"

#include "ui/panels/legend_scale.h"

#include <gtest/gtest.h>

namespace hanei {
namespace {

ColourScale office_scale() { return {50.0, 1000.0, "linear", true, {300.0, 500.0}, "{\"by\": \"hand\"}"}; }

TEST(ProjectScale, shows_every_picture_as_the_project_says) {
    Scene scene;
    scene.colour_scale = office_scale();
    ViewOptions look;
    ProjectScale scale;
    scale.follow(look, scene, nullptr);
    EXPECT_EQ(look.range, (LuxRange{50.0, 1000.0}));
    EXPECT_EQ(look.steps, ColourSteps::linear);
    EXPECT_FALSE(scale.wished(scene, look)) << "nothing was changed";
}

TEST(ProjectScale, becomes_the_projects_with_its_first_change_and_keeps_unknown_fields) {
    Scene scene;
    ViewOptions look;
    ProjectScale scale;
    scale.follow(look, scene, nullptr);
    look.range.high = 750.0;
    const auto first = scale.wished(scene, look);
    ASSERT_TRUE(first && first->colour_scale);
    EXPECT_EQ(first->colour_scale->high, 750.0);
    scene.colour_scale = office_scale();
    scale.follow(look, scene, nullptr);
    look.steps = ColourSteps::standard_steps;
    const auto second = scale.wished(scene, look);
    ASSERT_TRUE(second);
    EXPECT_EQ(second->colour_scale->steps, "en");
    EXPECT_EQ(second->colour_scale->unknown, office_scale().unknown);
}

TEST(ProjectScale, returns_to_the_fitted_range_when_its_change_is_undone) {
    Scene scene;
    ViewOptions look;
    ProjectScale scale;
    scale.follow(look, scene, nullptr);
    const LuxRange fitted = look.range;
    look.range.low = 77.0;
    scale.follow(look, *scale.wished(scene, look), nullptr);
    EXPECT_EQ(look.range.low, 77.0);
    scale.follow(look, scene, nullptr);
    EXPECT_EQ(look.range, fitted);
}

TEST(IsoluxLevels, are_read_as_people_write_them) {
    EXPECT_EQ(levels_in("500, 100;300  100", IlluminanceUnit::lux), (std::vector<double>{100.0, 300.0, 500.0}));
    EXPECT_EQ(levels_in("  ", IlluminanceUnit::lux), std::vector<double>{});
    EXPECT_FALSE(levels_in("100 lx", IlluminanceUnit::lux));
    EXPECT_FALSE(levels_in("-3", IlluminanceUnit::lux));
    EXPECT_FALSE(levels_in("0", IlluminanceUnit::lux));
    EXPECT_FALSE(levels_in("1e300", IlluminanceUnit::lux));
    const auto candles = levels_in("50", IlluminanceUnit::foot_candle);
    ASSERT_TRUE(candles && candles->size() == 1);
    EXPECT_NEAR(candles->front(), 538.2, 0.05);
    EXPECT_EQ(levels_text(*candles, IlluminanceUnit::foot_candle), "50");
    std::string many;
    for (int k = 1; k <= 65; ++k) many += std::to_string(k) + " ";
    EXPECT_FALSE(levels_in(many, IlluminanceUnit::lux)) << "more than a picture draws";
}

TEST(EndsOfTheScale, move_in_ratios_or_steps_and_never_meet) {
    ViewOptions look;
    look.range = {10.0, 1000.0};
    EXPECT_EQ(range_dragged(look, true, 0.5).high, 10000.0);  // half the bar is a factor of ten
    EXPECT_EQ(range_dragged(look, false, -0.5).low, 1.0);
    EXPECT_GT(range_dragged(look, true, -5.0).high, look.range.low);
    EXPECT_LT(range_dragged(look, false, 5.0).low, look.range.high);
    look.steps = ColourSteps::linear;
    EXPECT_EQ(range_dragged(look, true, 0.5).high, 1500.0);  // two digits of 1495
    EXPECT_GT(range_dragged(look, false, -9.0).low, 0.0);
}

}  // namespace
}  // namespace hanei
