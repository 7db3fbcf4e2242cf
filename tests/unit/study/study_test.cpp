#include "engine/study/study.h"

#include "tests/box_room.h"

#include <algorithm>
#include <gtest/gtest.h>

namespace hanei {
namespace {

SceneSnapshot snapshot(Scene scene) { return std::make_shared<const Scene>(std::move(scene)); }

Settings coarse_settings() {
    Settings settings;
    settings.max_patch = 0.8;
    settings.accuracy = 1e-6;
    settings.threads = 1;
    return settings;
}

std::vector<double> values_of(const Solution& solution) {
    std::vector<double> values;
    for (const PointResult& point : solution.points) {
        values.push_back(point.value.direct.value);
        values.push_back(point.value.interreflected.value);
        values.push_back(point.value.error.total());
    }
    values.insert(values.end(), solution.exitance.begin(), solution.exitance.end());
    return values;
}

/// Stages of a second study on the same scene after `edit`, by whether they were reused.
class Invalidation : public testing::Test {
protected:
    void run(const std::function<void(Scene&)>& edit) {
        Scene scene = test::small_office();
        Study study;
        study.run(snapshot(scene), coarse_settings(), StudyRequest{}, Work{});
        edit(scene);
        second_ = study.run(snapshot(scene), coarse_settings(), StudyRequest{}, Work{});
        const auto fresh = Study().run(snapshot(scene), coarse_settings(), StudyRequest{}, Work{});
        EXPECT_EQ(values_of(*second_), values_of(*fresh)) << "what was kept changed the answer";
    }
    bool reused(Stage stage) const {
        return std::any_of(second_->times.begin(), second_->times.end(),
                           [&](const StageTime& time) { return time.stage == stage && time.reused; });
    }
    SolutionSnapshot second_;
};

TEST_F(Invalidation, nothing_changed_reuses_every_stage) {
    run([](Scene&) {});
    for (const Stage stage : {Stage::direct, Stage::factors, Stage::balance, Stage::gathering})
        EXPECT_TRUE(reused(stage));
}

TEST_F(Invalidation, a_new_view_reuses_every_stage) {
    run([](Scene& scene) {
        scene.views.push_back({scene.new_id(), "new", {1.0, 1.0, 1.0}, {2.0, 2.0, 1.0}, 0.9, false, {}});
    });
    for (const Stage stage : {Stage::direct, Stage::factors, Stage::balance, Stage::gathering})
        EXPECT_TRUE(reused(stage));
}

TEST_F(Invalidation, a_moved_calculation_point_leaves_the_balance_alone) {
    run([](Scene& scene) { scene.points.front().position.x += 0.3; });
    for (const Stage stage : {Stage::direct, Stage::factors, Stage::balance}) EXPECT_TRUE(reused(stage));
    EXPECT_FALSE(reused(Stage::gathering));
}

TEST_F(Invalidation, dimming_computes_nothing_anew) {
    run([](Scene& scene) { scene.luminaires.front().dimming = 0.4; });
    EXPECT_TRUE(reused(Stage::direct));
    EXPECT_TRUE(reused(Stage::factors));
    EXPECT_TRUE(reused(Stage::balance)) << "a dimmed group is mixed, not solved";
}

TEST_F(Invalidation, the_maintenance_factor_computes_nothing_anew) {
    run([](Scene& scene) { scene.maintenance_factor = 0.8; });
    EXPECT_TRUE(reused(Stage::direct));
    EXPECT_TRUE(reused(Stage::factors));
    EXPECT_TRUE(reused(Stage::balance)) << "a dimmed group is mixed, not solved";
}

TEST_F(Invalidation, a_change_of_reflectance_redoes_the_balance_only) {
    run([](Scene& scene) { scene.materials.front().reflectance = 0.7; });
    EXPECT_TRUE(reused(Stage::direct));
    EXPECT_TRUE(reused(Stage::factors));
    EXPECT_FALSE(reused(Stage::balance));
}

TEST_F(Invalidation, another_material_on_a_wall_redoes_the_balance_only) {
    run([](Scene& scene) {
        scene.materials.push_back({scene.new_id(), "dark", 0.1, {}});
        scene.room->wall_materials.front() = scene.materials.back().id;
    });
    EXPECT_TRUE(reused(Stage::direct));
    EXPECT_TRUE(reused(Stage::factors));
    EXPECT_FALSE(reused(Stage::balance));
}

TEST_F(Invalidation, a_moved_luminaire_leaves_form_factors_alone) {
    run([](Scene& scene) { scene.luminaires.front().position.x += 0.5; });
    EXPECT_FALSE(reused(Stage::direct));
    EXPECT_TRUE(reused(Stage::factors));
    EXPECT_FALSE(reused(Stage::balance));
}

TEST_F(Invalidation, a_moved_opaque_luminaire_shadows_where_it_hangs_now) {
    const auto hang_opaque = [](Scene& scene) {
        for (Luminaire& luminaire : scene.luminaires) {
            luminaire.opaque = true;
            luminaire.position.z = 2.5;
        }
    };
    Scene scene = test::small_office();
    hang_opaque(scene);
    Study study;
    study.run(snapshot(scene), coarse_settings(), StudyRequest{}, Work{});
    for (const double x : {1.2, 2.6, 4.0}) {
        scene.luminaires.front().position.x = x;
        const auto kept = study.run(snapshot(scene), coarse_settings(), StudyRequest{}, Work{});
        EXPECT_EQ(values_of(*kept),
                  values_of(*Study().run(snapshot(scene), coarse_settings(), StudyRequest{}, Work{})));
    }
}

TEST_F(Invalidation, a_moved_opaque_luminaire_uncovers_the_ceiling_it_lay_on) {
    Scene scene = test::small_office();
    scene.luminaires.front().opaque = true;
    scene.luminaires.front().position.z = 2.8;
    scene.points.push_back(test::point(scene, {1.8, 2.0, 2.8}, {0.0, 0.0, -1.0}));
    Study study;
    study.run(snapshot(scene), coarse_settings(), StudyRequest{}, Work{});
    scene.luminaires.front().position.x = 4.8;
    const auto kept = study.run(snapshot(scene), coarse_settings(), StudyRequest{}, Work{});
    EXPECT_EQ(values_of(*kept), values_of(*Study().run(snapshot(scene), coarse_settings(), StudyRequest{}, Work{})));
    EXPECT_GT(kept->points.back().value.total().value, 1.0);
}

TEST_F(Invalidation, moved_furniture_redoes_form_factors_and_direct_light) {
    run([](Scene& scene) { scene.furniture.front().position.x += 0.5; });
    for (const Stage stage : {Stage::direct, Stage::factors, Stage::balance}) EXPECT_FALSE(reused(stage));
}

TEST_F(Invalidation, another_room_shape_redoes_everything) {
    run([](Scene& scene) { scene.room->height = 3.1; });
    for (const Stage stage : {Stage::direct, Stage::factors, Stage::balance, Stage::gathering})
        EXPECT_FALSE(reused(stage));
}

TEST(Study, the_same_bits_on_one_thread_on_two_and_on_seven) {
    for (const Method method : methods) {
        std::vector<std::vector<double>> results;
        for (const int threads : {1, 2, 7}) {
            Settings settings = coarse_settings();
            settings.method = method;
            settings.bounces = is_of_the_paper(method) ? 4 : 1000;
            settings.threads = threads;
            results.push_back(
                values_of(*Study().run(snapshot(test::small_office()), settings, StudyRequest{}, Work{})));
        }
        EXPECT_EQ(results[0], results[1]);
        EXPECT_EQ(results[0], results[2]);
    }
}

TEST(Study, dimming_every_luminaire_to_half_halves_every_value) {
    Scene scene = test::small_office();
    const auto full = Study().run(snapshot(scene), coarse_settings(), StudyRequest{}, Work{});
    for (Luminaire& luminaire : scene.luminaires) luminaire.dimming = 0.5;
    const auto half = Study().run(snapshot(scene), coarse_settings(), StudyRequest{}, Work{});
    for (std::size_t k = 0; k < full->points.size(); ++k) {
        EXPECT_NEAR(half->points[k].value.total().value, 0.5 * full->points[k].value.total().value,
                    1e-4);  // lx; the iteration may end one bounce apart
    }
}

TEST(Study, a_stopped_study_gives_nothing) {
    std::stop_source stop;
    stop.request_stop();
    EXPECT_EQ(
        Study().run(snapshot(test::small_office()), coarse_settings(), StudyRequest{}, Work{.stop = stop.get_token()}),
        nullptr);
}

TEST(Study, direct_light_is_published_before_the_full_answer) {
    std::vector<SolutionSnapshot> published;
    const auto full = Study().run(snapshot(test::small_office()), coarse_settings(), StudyRequest{.display = true},
                                  Work{}, [&](SolutionSnapshot part) { published.push_back(std::move(part)); });
    ASSERT_FALSE(published.empty());
    EXPECT_FALSE(published.front()->complete);
    EXPECT_TRUE(full->complete);
    EXPECT_EQ(published.front()->patch_direct, full->patch_direct);
    ASSERT_TRUE(published.front()->display && full->display);
    EXPECT_EQ(published.front()->display->cells.size(), full->display->cells.size());
}

TEST(Study, the_value_at_a_place_is_the_value_of_the_point_there) {
    const auto solution = Study().run(snapshot(test::small_office()), coarse_settings(), StudyRequest{}, Work{});
    for (const PointResult& point : solution->points) {
        const PointValue value = value_at(*solution, point.position, point.normal);
        EXPECT_DOUBLE_EQ(value.direct.value, point.value.direct.value);
        EXPECT_NEAR(value.interreflected.value, point.value.interreflected.value, 1e-9);
        EXPECT_NEAR(value.error.total(), point.value.error.total(), 1e-9);
    }
}

TEST(Study, a_place_inside_furniture_has_no_illuminance) {
    Scene scene = test::small_office();
    scene.points = {test::point(scene, {2.0, 2.0, 0.3})};
    const auto solution = Study().run(snapshot(scene), coarse_settings(), StudyRequest{}, Work{});
    EXPECT_TRUE(solution->points.front().value.inside_solid);
    EXPECT_TRUE(value_at(*solution, {2.0, 2.0, 0.3}, {0.0, 0.0, 1.0}).inside_solid);
}

TEST(Study, floor_under_a_standing_box_counts_as_inside_and_its_top_does_not) {
    Scene scene = test::small_office();
    scene.points = {test::point(scene, {2.0, 2.0, 0.0}), test::point(scene, {2.0, 2.0, 0.72})};
    const auto solution = Study().run(snapshot(scene), coarse_settings(), StudyRequest{}, Work{});
    EXPECT_TRUE(solution->points[0].value.inside_solid);
    EXPECT_FALSE(solution->points[1].value.inside_solid);
}

TEST(Study, error_bars_cover_the_difference_to_a_much_finer_solution) {
    const auto coarse = Study().run(snapshot(test::small_office()), coarse_settings(), StudyRequest{}, Work{});
    Settings fine = coarse_settings();
    fine.max_patch = 0.2;
    const auto better = Study().run(snapshot(test::small_office()), fine, StudyRequest{.mesh_error = false}, Work{});
    for (std::size_t k = 0; k < coarse->points.size(); ++k) {
        const PointValue& value = coarse->points[k].value;
        EXPECT_LE(std::abs(value.total().value - better->points[k].value.total().value), value.error.total());
        EXPECT_GT(value.error.total(), 0.0);
    }
}

TEST(Study, emitted_flux_is_absorbed_in_a_closed_room) {
    Settings settings = coarse_settings();
    settings.max_patch = 0.3;
    const auto solution = Study().run(snapshot(test::small_office()), settings, StudyRequest{}, Work{});
    EXPECT_NEAR(solution->energy.emitted, 7200.0, 1e-9);
    EXPECT_NEAR(solution->energy.absorbed, 7200.0, 0.01 * 7200.0);  // patch width 0.3 m
}

}  // namespace
}  // namespace hanei
