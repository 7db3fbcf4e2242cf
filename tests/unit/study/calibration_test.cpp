#include "engine/study/calibration.h"

#include "tests/unit/study/runs.h"

#include <gtest/gtest.h>

namespace hanei {
namespace {

CalibrationSample sample(const ExpectedWork& work, double ns, double error) {
    CalibrationSample made;
    made.method = Method::patch;
    made.unknowns = work.unknowns;
    made.room = work.room;
    made.ns_a_unit.fill(ns);
    made.error = error;
    return made;
}

Settings wide(double width) {
    Settings settings;
    settings.max_patch = width;
    return settings;
}

TEST(Calibration, what_was_studied_is_predicted_as_it_took) {
    const Scene scene = test::grouped_office();
    const ExpectedWork work = expected_work(scene, wide(0.5));
    const std::vector<StageTime> times{{Stage::planning, 1.0, false}, {Stage::meshing, 3.0, false},
                                       {Stage::direct, 20.0, false},  {Stage::factors, 40.0, false},
                                       {Stage::balance, 5.0, false},  {Stage::gathering, 31.0, false},
                                       {Stage::refining, 99.0, false}};
    Calibration calibration;
    CalibrationSample learned = sample_of(work, Method::patch, times);
    learned.error = 0.02;
    calibration.learn(learned);
    const Prediction prediction = calibration.predict(scene, wide(0.5));
    EXPECT_NEAR(prediction.ms, 100.0, 1e-9) << "pictures are no part of it";
    EXPECT_DOUBLE_EQ(prediction.error, 0.02);
    EXPECT_TRUE(prediction.same_room);
    EXPECT_EQ(prediction.studies, 1);
}

TEST(Calibration, without_studies_predicts_by_usual_figures_and_says_so) {
    const Scene scene = test::grouped_office();
    for (const Method method : methods) {
        Settings settings = wide(0.5);
        settings.method = method;
        const Prediction prediction = Calibration().predict(scene, settings);
        EXPECT_GT(prediction.ms, 0.0);
        EXPECT_GT(prediction.error, 0.0);
        EXPECT_EQ(prediction.studies, 0);
        EXPECT_FALSE(prediction.same_room);
    }
}

TEST(Calibration, narrower_patches_take_longer_and_err_less) {
    const Scene scene = test::grouped_office();
    const Prediction coarse = Calibration().predict(scene, wide(0.8)), fine = Calibration().predict(scene, wide(0.2));
    EXPECT_LT(coarse.ms, fine.ms);
    EXPECT_GT(coarse.error, fine.error);
}

TEST(Calibration, one_study_on_a_busy_machine_does_not_spoil_the_median) {
    const Scene scene = test::grouped_office();
    Scene other = scene;
    other.luminaires.front().position.x += 0.1;
    const ExpectedWork work = expected_work(scene, wide(0.5));
    Calibration calibration;
    for (const double ns : {10.0, 11.0, 900.0, 9.0, 10.0}) calibration.learn(sample(work, ns, 0.05));
    const double of_ten = 1e-5 * (work.units[0] + work.units[1] + work.units[2] + work.units[3] + work.units[4]);
    EXPECT_NEAR(calibration.predict(other, wide(0.5)).ms, of_ten, 1e-6 * of_ten);
}

TEST(Calibration, this_very_room_counts_more_than_others) {
    const Scene scene = test::grouped_office();
    Scene other = scene;
    other.luminaires.front().position.x += 0.1;
    Calibration calibration;
    for (int k = 0; k < 20; ++k) calibration.learn(sample(expected_work(other, wide(0.5)), 1000.0, 0.5));
    calibration.learn(sample(expected_work(scene, wide(0.4)), 10.0, 0.05));
    const Prediction prediction = calibration.predict(scene, wide(0.5));
    EXPECT_TRUE(prediction.same_room);
    EXPECT_LT(prediction.error, 0.1);
    EXPECT_FALSE(calibration.predict(test::small_office(), wide(0.5)).same_room);
}

TEST(Calibration, keeps_the_last_studies_alone) {
    Calibration calibration;
    for (std::size_t k = 0; k < Calibration::most_samples + 5; ++k) {
        CalibrationSample each;
        each.unknowns = static_cast<double>(k + 1);
        calibration.learn(each);
    }
    EXPECT_EQ(calibration.samples().size(), Calibration::most_samples);
    EXPECT_EQ(calibration.samples().front().unknowns, 6.0);
}

TEST(Calibration, of_an_empty_scene_is_finite) {
    const Prediction prediction = Calibration().predict(Scene{}, Settings{});
    EXPECT_TRUE(std::isfinite(prediction.ms));
    EXPECT_TRUE(std::isfinite(prediction.error));
}

}  // namespace
}  // namespace hanei
