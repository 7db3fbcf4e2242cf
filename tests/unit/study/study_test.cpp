#include "engine/study/study.h"

#include "tests/unit/study/runs.h"

#include <algorithm>
#include <gtest/gtest.h>

namespace hanei {
namespace {

using test::coarse_settings;
using test::snapshot;

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

TEST(Study, all_flux_of_a_closed_room_is_accounted_for) {
    for (const Method method : {Method::patch, Method::linear}) {
        Settings settings = coarse_settings();
        settings.max_patch = 0.3;
        settings.method = method;
        const auto solution =
            Study().run(snapshot(test::small_office()), settings, StudyRequest{.energy = true}, Work{});
        const EnergyBalance& energy = solution->energy;
        EXPECT_NEAR(energy.emitted, 7200.0, 1e-9);
        EXPECT_NEAR(energy.imbalance(), 0.0, 1e-3 * 7200.0);
        EXPECT_GT(energy.absorbed, 0.9 * 7200.0);
        EXPECT_GE(energy.escaped, 0.0);
    }
}

/// Found by chance: linear elements looked for light to refine where there was none.
TEST(Study, a_shining_sheet_behind_another_in_its_place_gives_no_light) {
    Scene scene;
    scene.materials = {{scene.new_id(), "grey", 0.5, {}}};
    const Polygon outline{{0.0, 0.0, 1.0}, {1.0, 0.0, 1.0}, {1.0, 1.0, 1.0}, {0.0, 1.0, 1.0}};
    const auto hang = [&](LuminousExitance own) {
        scene.surfaces.push_back({scene.new_id(), "sheet", {outline, {}}, scene.materials.front().id, own, {}});
    };
    hang({1000.0});
    hang({0.0});
    scene.points = {test::point(scene, {0.5, 0.5, 2.0}, {0.0, 0.0, -1.0})};
    for (const Method method : methods) {
        const auto solution = Study().run(snapshot(scene), coarse_settings(method), {.energy = true}, Work{});
        EXPECT_EQ(solution->points.front().value.total().value, 0.0) << name_of(method);
        EXPECT_EQ(solution->energy.emitted, 0.0) << name_of(method);
    }
}

TEST(Study, black_surfaces_absorb_all_that_arrives) {
    Scene scene = test::box_room({4.0, 3.0, 2.6}, 0.0);
    scene.luminaires.push_back(test::panel(scene, {2.0, 1.5, 2.5}, {0.8, 0.4}, 3000.0));
    for (const Method method : methods) {
        const auto solution = Study().run(snapshot(scene), coarse_settings(method), {.energy = true}, Work{});
        EXPECT_NEAR(solution->energy.absorbed, 3000.0, 3.0) << name_of(method);
    }
}

TEST(Study, patches_too_fine_to_be_solved_are_widened_and_it_is_said) {
    Scene dark = test::small_office();
    dark.luminaires.clear();  // no interreflection: the mesh alone is made
    Settings fine = coarse_settings();
    fine.max_patch = 1e-4;
    const auto solution = Study().run(snapshot(dark), fine, StudyRequest{}, Work{});
    EXPECT_LE(solution->mesh->patches.size(), 55'000);  // cutting may add some to the 50,000
    EXPECT_EQ(solution->settings, fine);
    EXPECT_GT(solution->patch_width, 0.01);
    ASSERT_FALSE(solution->notes.empty());
    EXPECT_EQ(solution->notes.front().rfind("Patches of 0.0001 m would be more than can be solved", 0), 0);
}

TEST(Study, a_closed_room_that_reflects_everything_is_refused_and_named) {
    Scene scene = test::box_room({4.0, 3.0, 2.5}, 1.0);
    scene.luminaires.push_back(test::point_source(scene, {2.0, 1.5, 1.25}, 5000.0));
    scene.points = {test::point(scene, {1.0, 1.0, 0.0})};
    for (const Method method : {Method::patch, Method::linear}) {
        Settings settings = coarse_settings();
        settings.method = method;
        const auto refused = Study().run(snapshot(scene), settings, StudyRequest{}, Work{});
        EXPECT_NE(refused->refusal.find(scene.materials.front().name), std::string::npos) << refused->refusal;
        EXPECT_GT(refused->points.front().value.error.iteration, 1e6);  // no bound
        scene.materials.front().reflectance = 0.99;
        const auto solved = Study().run(snapshot(scene), settings, StudyRequest{}, Work{});
        EXPECT_TRUE(solved->refusal.empty());
        EXPECT_TRUE(solved->converged);
        scene.materials.front().reflectance = 1.0;
    }
}

}  // namespace
}  // namespace hanei
