#include "engine/study/presets.h"

#include "tests/unit/study/runs.h"

#include <gtest/gtest.h>

namespace hanei {
namespace {

/// A machine on which `patch` takes a millisecond a thousand pairs and errs by 5 % at 1000 unknowns.
Calibration of_a_room(const Scene& scene, double error) {
    Calibration calibration;
    for (const Method method : methods) {
        Settings settings;
        settings.method = method;
        settings.max_patch = 0.5;
        const ExpectedWork work = expected_work(scene, settings);
        CalibrationSample sample;
        sample.method = method;
        sample.unknowns = work.unknowns;
        sample.room = work.room;
        sample.ns_a_unit = {100.0, 100.0, method == Method::linear ? 300.0 : 10.0, 1.0, 10.0};
        sample.error = method == Method::linear ? 0.1 * error : error;
        calibration.learn(sample);
    }
    return calibration;
}

TEST(Presets, are_named_as_they_are_written) {
    for (const Preset preset : presets) EXPECT_EQ(preset_named(name_of(preset)), preset);
    EXPECT_FALSE(preset_named("best"));
    EXPECT_GT(wished_error(Preset::draft), wished_error(Preset::design));
    EXPECT_GT(wished_error(Preset::design), wished_error(Preset::verify));
}

TEST(Presets, the_wish_is_met_by_the_prediction_and_asks_no_more_time_than_a_stricter_one) {
    const Scene scene = test::grouped_office();
    const Calibration calibration = of_a_room(scene, 0.05);
    double last = 0.0;
    for (const double wish : {0.2, 0.1, 0.05, 0.03, 0.02}) {
        const Suggestion suggestion = settings_for(scene, {}, wish, calibration);
        EXPECT_TRUE(suggestion.reaches) << wish;
        EXPECT_LE(suggestion.prediction.error, wish);
        EXPECT_GE(suggestion.prediction.ms, last) << wish;
        EXPECT_LT(suggestion.settings.accuracy, wish) << "iterating leaves less unknown than what is wished";
        last = suggestion.prediction.ms;
    }
}

TEST(Presets, keep_threads_and_memory_as_they_are_set) {
    Settings from;
    from.threads = 3;
    from.memory_mb = 77;
    const Suggestion suggestion = settings_for(test::grouped_office(), from, Preset::design, {});
    EXPECT_EQ(suggestion.settings.threads, 3);
    EXPECT_EQ(suggestion.settings.memory_mb, 77);
}

TEST(Presets, say_when_nothing_reaches_the_wish) {
    const Scene scene = test::grouped_office();
    const Suggestion suggestion = settings_for(scene, {}, least_wish, of_a_room(scene, 30.0));
    EXPECT_FALSE(suggestion.reaches);
    EXPECT_GT(suggestion.prediction.error, least_wish);
    EXPECT_EQ(suggestion.settings.method, Method::linear) << "the most exact there is";
}

TEST(Presets, of_a_scene_without_faces_change_nothing) {
    Settings from;
    from.max_patch = 0.31;
    const Suggestion suggestion = settings_for({}, from, Preset::verify, {});
    EXPECT_EQ(suggestion.settings, from);
    EXPECT_FALSE(suggestion.reaches);
}

TEST(Presets, a_wish_that_is_no_number_is_an_ordinary_one) {
    const double nothing = std::numeric_limits<double>::quiet_NaN();
    const Suggestion suggestion = settings_for(test::grouped_office(), {}, nothing, {});
    EXPECT_TRUE(std::isfinite(suggestion.settings.max_patch));
    EXPECT_TRUE(std::isfinite(suggestion.prediction.ms));
}

}  // namespace
}  // namespace hanei
