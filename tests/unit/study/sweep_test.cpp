#include "engine/study/sweep.h"

#include "engine/study/sweep_plan.h"
#include "tests/unit/study/runs.h"

#include <algorithm>
#include <gtest/gtest.h>

namespace hanei {
namespace {

Settings quick() {
    Settings settings;
    settings.max_patch = 2.0;
    settings.threads = 1;
    return settings;
}

TEST(SweepPlan, holds_the_present_settings_the_papers_own_and_all_presets_first) {
    const Scene scene = test::grouped_office();
    Settings settings = quick();
    settings.bounces = 7;
    const auto runs = planned_runs(scene, settings, {}, true);
    int current = 0, papers = 0, of_presets = 0;
    bool wanted_before = true;
    for (const PlannedRun& run : runs) {
        EXPECT_LE(run.wanted, wanted_before) << "what is wanted comes first";
        wanted_before = run.wanted;
        std::vector<int> all = run.fewer;
        all.push_back(run.settings.bounces);
        for (const int bounces : all) {
            const SweepMarks marks = marks_of(run, bounces, settings);
            current += marks.current;
            papers += marks.paper;
            of_presets += marks.preset.has_value();
        }
    }
    EXPECT_EQ(current, 1) << "seven interreflections are none of the usual few";
    EXPECT_EQ(papers, 1);
    EXPECT_EQ(of_presets, 3);
}

TEST(SweepPlan, does_not_try_shadows_where_nothing_stands_between) {
    const auto runs = planned_runs(test::grouped_office(), quick(), {}, false);
    EXPECT_TRUE(std::all_of(runs.begin(), runs.end(), [](const PlannedRun& run) { return run.shadows; }));
}

TEST(Sweep, tells_errors_times_and_the_uncertainty_of_what_they_are_against) {
    const auto scene = test::snapshot(test::grouped_office());
    SweepWish wish;
    wish.budget = 100.0;
    std::stop_source stop;
    int told = 0;
    wish.on_way = [&](const Sweep&) {
        if (++told == 10) stop.request_stop();  // a coarse one, the two that errors are against, seven more
    };
    const Sweep sweep = accuracy_sweep(scene, quick(), wish, {1, stop.get_token(), nullptr});
    EXPECT_TRUE(sweep.stopped);
    ASSERT_FALSE(sweep.points.empty());
    EXPECT_EQ(sweep.uncertainty.set, "all");
    EXPECT_GT(sweep.uncertainty.max, 0.0) << "two runs of different kinds never agree to the last digit";
    EXPECT_NE(sweep.against.find("linear"), std::string::npos);
    EXPECT_NE(sweep.uncertainty_words.find("patch"), std::string::npos);
    bool some_on_frontier = false;
    double one = -1.0, all = -1.0;  // interreflections of the same run
    for (const SweepPoint& point : sweep.points) {
        EXPECT_GT(point.milliseconds, 0.0);
        EXPECT_GT(point.unknowns, 0U);
        ASSERT_FALSE(point.errors.empty());
        EXPECT_LE(point.errors.front().mean, point.errors.front().max);
        EXPECT_LE(point.errors.front().p95_lux, point.errors.front().max_lux);
        some_on_frontier = some_on_frontier || point.on_frontier;
        if (point.settings.method != Method::patch || point.settings.max_patch != 2.0) continue;
        if (point.settings.bounces == 1) one = point.errors.front().mean;
        if (point.complete) all = point.errors.front().mean;
    }
    EXPECT_TRUE(some_on_frontier);
    ASSERT_GE(all, 0.0);
    EXPECT_GT(one, all);
    EXPECT_FALSE(sweep.learned.empty());
    EXPECT_EQ(sweep.lumen.refusal, "");
    EXPECT_GT(sweep.lumen.predicted, 0.25 * sweep.lumen.solved);
    EXPECT_LT(sweep.lumen.predicted, 4.0 * sweep.lumen.solved);
}

TEST(Sweep, leaves_out_what_is_predicted_to_go_beyond_the_budget) {
    const auto scene = test::snapshot(test::grouped_office());
    SweepWish wish;
    wish.budget = 0.001;
    const Sweep sweep = accuracy_sweep(scene, quick(), wish, {});
    EXPECT_TRUE(sweep.points.empty());
    EXPECT_EQ(sweep.left_out.size(), planned_runs(*scene, quick(), {}, sweep.something_between).size());
    for (const OmittedRun& run : sweep.left_out) EXPECT_GT(run.predicted_ms, 0.0);
}

TEST(Sweep, ends_runs_that_take_longer_than_was_predicted_and_left) {
    Scene room = test::grouped_office();
    room.grids.clear();
    room.points = {{room.new_id(), "desk", {2.0, 2.0, 0.76}, {0.0, 0.0, 1.0}, {}}};
    SweepExpected expected{"what was measured", {400.0}, {"desk"}, {8.0}};
    Settings fine = quick();
    fine.max_patch = 0.1;  // all runs take minutes together
    SweepWish wish;
    wish.expected = &expected;
    wish.budget = 1.0;
    for (const Method method : methods)
        wish.calibration.learn({method, 1000.0, expected_work(room, fine).room, {1e-9, 1e-9, 1e-9, 1e-9, 1e-9}, 0.01});
    const Sweep sweep = accuracy_sweep(test::snapshot(room), fine, wish, {1, {}, nullptr});
    EXPECT_FALSE(sweep.stopped);
    EXPECT_FALSE(sweep.left_out.empty());
}

TEST(Sweep, stops_when_asked_and_says_so) {
    std::stop_source stop;
    stop.request_stop();
    const Sweep sweep =
        accuracy_sweep(test::snapshot(test::grouped_office()), quick(), {}, {1, stop.get_token(), nullptr});
    EXPECT_TRUE(sweep.stopped);
    EXPECT_TRUE(sweep.points.empty());
}

TEST(Sweep, takes_values_from_elsewhere_with_the_uncertainty_they_state) {
    Scene room = test::grouped_office();
    room.grids.clear();
    room.points = {{room.new_id(), "desk", {2.0, 2.0, 0.76}, {0.0, 0.0, 1.0}, {}}};
    SweepExpected expected{"what was measured", {400.0}, {"desk"}, {8.0}};
    SweepWish wish;
    wish.expected = &expected;
    std::stop_source stop;
    wish.on_way = [&](const Sweep&) { stop.request_stop(); };
    const Sweep sweep = accuracy_sweep(test::snapshot(room), quick(), wish, {1, stop.get_token(), nullptr});
    EXPECT_EQ(sweep.against, "what was measured");
    EXPECT_DOUBLE_EQ(sweep.uncertainty.mean, 0.02);
    EXPECT_DOUBLE_EQ(sweep.uncertainty.max_lux, 8.0);
}

TEST(SweepErrors, dark_places_count_for_what_they_light) {
    const std::vector<ComparedValue> expected{{100.0, "a"}, {100.0, "a"}, {0.0, "b"}, {-1.0, "b"}};
    std::vector<ComparedValue> got = expected;
    got[2].lux = 1.0;
    const auto errors = errors_by_set(got, expected);
    ASSERT_EQ(errors.size(), 3U) << "all, a, b";
    EXPECT_NEAR(errors[0].max, 1.0 / (0.1 * 200.0 / 3.0), 1e-12);
    EXPECT_DOUBLE_EQ(errors[0].max_lux, 1.0);
    EXPECT_DOUBLE_EQ(errors[1].max, 0.0);
}

TEST(SweepErrors, what_is_no_number_is_as_wrong_as_can_be) {
    const std::vector<ComparedValue> expected{{100.0, "a"}};
    const auto errors = errors_by_set({{std::numeric_limits<double>::quiet_NaN(), "a"}}, expected);
    EXPECT_GT(errors[0].mean, 1e6);
    EXPECT_TRUE(std::isfinite(errors[0].max));
}

}  // namespace
}  // namespace hanei
