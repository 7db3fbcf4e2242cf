/// What effects really add and take.
#include "engine/study/effect_trials.h"

#include "tests/box_room.h"

#include <gtest/gtest.h>

namespace hanei {
namespace {

SceneSnapshot furnished_room() {
    Scene scene = test::box_room({4.0, 3.0, 2.6}, 0.5);
    scene.luminaires.push_back(test::panel(scene, {2.0, 1.5, 2.5}, {0.8, 0.4}, 3000.0));
    scene.furniture = {test::box(scene, {1.0, 1.0, 0.0}, {0.8, 0.6, 0.7})};
    scene.points = {test::point(scene, {3.0, 2.0, 0.0}), test::point(scene, {1.6, 1.0, 0.2}, {-1.0, 0.0, 0.0})};
    return std::make_shared<const Scene>(std::move(scene));
}

TEST(EffectTrials, try_what_the_scene_has_and_find_no_more_than_is_bounded) {
    const auto trials = try_effects(furnished_room(), {}, {});
    ASSERT_TRUE(trials);
    EXPECT_EQ(trials->places, 2U);
    EXPECT_GT(trials->everything_ms, 0.0);
    ASSERT_EQ(trials->trials.size(), 3U);
    for (const Effect effect : {Effect::interreflection, Effect::occlusion_patches, Effect::furniture}) {
        const EffectTrial* const trial = trials->of(effect);
        ASSERT_NE(trial, nullptr) << name_of(effect);
        EXPECT_GT(trial->change_lux, 0.0) << name_of(effect);
        EXPECT_LE(trial->mean_change_lux, trial->change_lux) << name_of(effect);
        EXPECT_DOUBLE_EQ(trial->without_ms + trial->saved_ms, trials->everything_ms);
        EXPECT_LE(trial->change_lux, trial->bound_lux) << name_of(effect);
    }
    EXPECT_GT(trials->of(Effect::interreflection)->change_lux, trials->of(Effect::furniture)->change_lux);
    EXPECT_EQ(trials->of(std::nullopt), nullptr);
}

TEST(EffectTrials, hold_the_plan_against_everything_where_it_skips_something) {
    Settings settings;
    settings.furniture = EffectChoice::never;
    const auto trials = try_effects(furnished_room(), settings, {});
    ASSERT_TRUE(trials);
    const EffectTrial* const plan = trials->of(std::nullopt);
    ASSERT_NE(plan, nullptr);
    EXPECT_EQ(plan->change_lux, trials->of(Effect::furniture)->change_lux);
    EXPECT_GT(plan->change_lux, 0.0);
    EXPECT_GT(plan->bound_lux, plan->change_lux);
}

TEST(EffectTrials, are_none_when_stopped) {
    std::stop_source stop;
    stop.request_stop();
    EXPECT_FALSE(try_effects(furnished_room(), {}, {1, stop.get_token(), nullptr}));
}

}  // namespace
}  // namespace hanei
