#include "engine/study/trust.h"

#include "engine/study/study.h"
#include "engine/study/trust_rays.h"
#include "tests/unit/study/runs.h"

#include <gtest/gtest.h>

namespace hanei {
namespace {

using test::coarse_settings;
using test::snapshot;

TrustReport report_of(const Scene& scene, Method method = Method::patch, int bounces = 1000) {
    Settings settings = coarse_settings(method);
    settings.max_patch = 0.5;
    settings.accuracy = 1e-3;
    settings.bounces = bounces;
    return *trust_in(snapshot(scene), settings, Work{});
}

TEST(Trust, the_small_office_holds_in_every_respect) {
    int told = 0;
    Settings settings = coarse_settings();
    const auto report = trust_in(snapshot(test::small_office()), settings, Work{},
                                 [&](const TrustReport& on_way) { EXPECT_EQ(on_way.done, ++told); });
    EXPECT_EQ(told, TrustReport::checks);
    EXPECT_EQ(report->direct.figure().state(), TrustState::holds) << report->direct.missing();
    EXPECT_EQ(report->energy.figure().state(), TrustState::holds) << report->energy.unexplained();
    EXPECT_EQ(report->reciprocity.figure().state(), TrustState::holds) << report->reciprocity.worst()->ratio();
    EXPECT_EQ(report->closure.figure().state(), TrustState::holds) << report->closure.misplaced;
    EXPECT_EQ(report->additivity.figure().state(), TrustState::holds) << report->additivity.worst_ratio;
    EXPECT_EQ(report->threads.figure().state(), TrustState::holds) << report->threads.others;
    EXPECT_TRUE(report->holds());
    EXPECT_EQ(report->reciprocity.pairs.size(), 15U);
}

TEST(Trust, light_on_its_way_after_the_last_reflection_is_explained) {
    const TrustReport report = report_of(test::small_office(), Method::patch, 2);
    const EnergyTrust& energy = report.energy;
    EXPECT_FALSE(energy.converged);
    EXPECT_GT(energy.explained(), 0.05 * energy.energy.emitted);  // reflectance 1/2: an eighth is sent a third time
    EXPECT_LT(std::abs(energy.unexplained()), 0.01 * energy.energy.emitted);
    EXPECT_EQ(energy.figure().state(), TrustState::holds);
}

TEST(Trust, a_tenth_of_the_light_gone_fails_by_energy) {
    EnergyTrust energy = report_of(test::small_office()).energy;
    energy.energy.absorbed *= 0.9;
    EXPECT_EQ(energy.figure().state(), TrustState::fails);
}

TEST(Trust, an_iteration_that_ended_has_no_more_on_its_way_than_its_bound) {
    EnergyTrust energy = report_of(test::small_office()).energy;
    ASSERT_TRUE(energy.converged);
    EXPECT_LE(std::abs(energy.under_way), energy.iteration_bound);
    energy.energy.absorbed -= 1000.0;
    energy.under_way += 1000.0;  // no excuse
    EXPECT_EQ(energy.figure().state(), TrustState::fails);
}

TEST(Trust, a_panel_half_outside_fails_by_direct_light_and_is_named) {
    Scene scene = test::small_office();
    scene.luminaires.back().position.x = 6.0;
    const TrustReport report = report_of(scene);
    EXPECT_EQ(report.direct.figure().state(), TrustState::fails);
    EXPECT_EQ(report.direct.worst, scene.luminaires.back().id);
    EXPECT_NEAR(report.direct.worst_missing, 1800.0, 20.0);        // half of 3600 lm
    EXPECT_EQ(report.energy.figure().state(), TrustState::holds);  // what has arrived is accounted for
    EXPECT_FALSE(report.holds());
}

TEST(Trust, point_to_point_factors_in_a_gap_fail_by_energy_and_by_closure) {
    Scene scene = test::small_office();
    scene.furniture.push_back(test::box(scene, {5.5, 2.0, 0.0}, {0.96, 2.0, 2.0}));  // 2 cm off the wall
    const TrustReport report = report_of(scene, Method::paper, 4);
    EXPECT_GT(report.closure.greatest, 2.0);
    EXPECT_EQ(report.closure.figure().state(), TrustState::fails);
    EXPECT_EQ(report.energy.figure().state(), TrustState::fails);
    EXPECT_TRUE(report_of(scene, Method::patch, 4).holds());
}

TEST(Trust, light_that_grows_from_reflection_to_reflection_is_called_divergent) {
    Scene scene = test::small_office();
    scene.furniture.push_back(
        test::box(scene, {5.54, 2.0, 0.0}, {0.9, 2.4, 1.4}));  // 1 cm off the wall, point on point
    Settings settings = coarse_settings(Method::paper);
    const auto paper = Study().run(snapshot(scene), settings, {}, Work{});
    ASSERT_FALSE(paper->notes.empty());
    EXPECT_EQ(paper->notes.back().rfind("Divergent", 0), 0U) << paper->notes.back();
    for (const Method method : {Method::patch, Method::paper_closed}) {
        settings.method = method;
        const auto closed = Study().run(snapshot(scene), settings, {}, Work{});
        for (const std::string& note : closed->notes) EXPECT_NE(note.rfind("Divergent", 0), 0U) << note;
    }
}

TEST(Trust, faces_that_do_not_light_each_other_alike_fail) {
    ReciprocityTrust trust = report_of(test::small_office()).reciprocity;
    ASSERT_EQ(trust.figure().state(), TrustState::holds);
    trust.pairs.front().back *= 1.5;
    EXPECT_EQ(trust.figure().state(), TrustState::fails);
    EXPECT_EQ(trust.worst()->a, trust.pairs.front().a);
}

TEST(Trust, rays_count_what_a_place_sees_of_an_open_box) {
    Scene scene;
    const Material material{scene.new_id(), "plate", 0.5, {}};
    scene.materials.push_back(material);
    // a unit plate one metre above another: seen from the middle, corner by corner, by the closed form
    FreeSurface plate;
    plate.id = scene.new_id();
    plate.region.outline = {{0.0, 0.0, 1.0}, {0.0, 1.0, 1.0}, {1.0, 1.0, 1.0}, {1.0, 0.0, 1.0}};
    plate.material = material.id;
    scene.surfaces.push_back(plate);
    const auto mesh = make_mesh(scene, 0.5);
    const double half = 0.5, root = std::sqrt(1.0 + half * half);
    const double seen = 4.0 / (2.0 * std::numbers::pi) * 2.0 * half / root * std::atan(half / root);
    constexpr std::size_t rays = 4096;
    const OccluderSet occluders = occluders_of(scene);
    const Receiver below{{0.5, 0.5, 0.0}, {0.0, 0.0, 1.0}, Vec3{0.0}};
    const auto met = RaysFrom(*mesh, &occluders, {}).meeting_a_surface(below, rays);
    EXPECT_NEAR(static_cast<double>(met) / rays, seen, 0.01);  // evenly spread: better than 3 standard errors
    const Receiver above{{0.5, 0.5, 2.0}, {0.0, 0.0, -1.0}, Vec3{0.0}};
    EXPECT_EQ(RaysFrom(*mesh, &occluders, {}).meeting_a_surface(above, rays), 0U) << "its back is no surface";
}

TEST(Trust, form_factors_that_miss_an_opening_fail_by_closure) {
    ClosureTrust trust = report_of(test::small_office()).closure;
    ASSERT_EQ(trust.figure().state(), TrustState::holds);
    EXPECT_NEAR(trust.seen_by_rays, 1.0, 1e-12);
    trust.worst_deviation = 6.0;
    EXPECT_EQ(trust.figure().state(), TrustState::fails);
    trust.worst_deviation = 0.0;
    trust.greatest_seen = 1.001;
    EXPECT_EQ(trust.figure().state(), TrustState::fails);
}

TEST(Trust, rows_that_send_other_than_what_is_seen_fail_by_closure) {
    ClosureTrust trust = report_of(test::small_office()).closure;
    trust.misplaced = 1.01 * trust.error_share + 1e-4;
    EXPECT_EQ(trust.figure().state(), TrustState::fails);
}

class Halves : public testing::Test {
protected:
    Halves() {
        Settings settings = coarse_settings();
        settings.accuracy = 1e-4;
        Scene scene = test::small_office();
        whole_ = *Study().run(snapshot(scene), settings, {}, Work{});
        scene.luminaires[0].dimming = 0.0;
        odd_ = *Study().run(snapshot(scene), settings, {}, Work{});
        scene.luminaires[0].dimming = 1.0;
        scene.luminaires[1].dimming = 0.0;
        even_ = *Study().run(snapshot(scene), settings, {}, Work{});
    }
    Solution whole_, odd_, even_;
};

TEST_F(Halves, make_the_whole) {
    AdditivityTrust trust = sum_of_parts(whole_, odd_, even_);
    trust.odd = trust.even = 1;
    EXPECT_EQ(trust.points, 3U);
    EXPECT_EQ(trust.within, 3U);
    EXPECT_TRUE(trust.same_patches);
    EXPECT_EQ(trust.figure().state(), TrustState::holds);
}

TEST_F(Halves, that_do_not_make_the_whole_fail_at_the_place_where_they_do_not) {
    odd_.points[1].value.interreflected.value *= 1.2;
    AdditivityTrust trust = sum_of_parts(whole_, odd_, even_);
    trust.odd = trust.even = 1;
    EXPECT_EQ(trust.within, 2U);
    EXPECT_EQ(trust.worst_place, whole_.points[1].position);
    EXPECT_EQ(trust.figure().state(), TrustState::fails);
    odd_.points[1].value.interreflected.value = std::nan("");
    EXPECT_EQ(sum_of_parts(whole_, odd_, even_).within, 2U) << "what is no number agrees with nothing";
}

TEST_F(Halves, other_bits_are_counted) {
    EXPECT_EQ(same_bits(whole_, whole_).figure().state(), TrustState::holds);
    Solution other = whole_;
    other.exitance[3] = std::nextafter(other.exitance[3], 0.0);
    EXPECT_EQ(same_bits(whole_, other).others, 1U);
    EXPECT_EQ(same_bits(whole_, other).figure().state(), TrustState::fails);
}

TEST(Trust, of_a_scene_without_light_nothing_is_asked_but_bits) {
    Scene scene = test::small_office();
    scene.luminaires.clear();
    const TrustReport report = report_of(scene);
    EXPECT_EQ(report.additivity.figure().state(), TrustState::not_asked);
    EXPECT_TRUE(report.holds());
}

TEST(Trust, a_room_that_keeps_all_its_light_has_no_balance_to_judge) {
    Scene scene = test::small_office();
    for (Material& material : scene.materials) material.reflectance = 1.0;
    const TrustReport report = report_of(scene);
    EXPECT_FALSE(report.solution->refusal.empty());
    EXPECT_EQ(report.energy.figure().state(), TrustState::not_asked);
    EXPECT_EQ(report.reciprocity.figure().state(), TrustState::not_asked);
    EXPECT_EQ(report.closure.figure().state(), TrustState::not_asked);
    EXPECT_EQ(report.direct.figure().state(), TrustState::holds);
    EXPECT_EQ(report.done, TrustReport::checks);
}

TEST(Trust, a_white_court_under_the_sky_loses_all_light_upwards_within_its_error_bars) {
    Scene scene = test::box_room({4.0, 3.0, 2.8}, 1.0);
    const Room room = *scene.room;
    scene.room.reset();
    const auto wall = [&](const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
        FreeSurface surface;
        surface.id = scene.new_id();
        surface.region.outline = {a, b, c, d};
        surface.material = scene.materials.front().id;
        scene.surfaces.push_back(surface);
    };
    const double x = 4.0, y = 3.0, z = room.height;
    wall({0, 0, 0}, {x, 0, 0}, {x, y, 0}, {0, y, 0});
    wall({0, 0, 0}, {0, 0, z}, {x, 0, z}, {x, 0, 0});
    wall({0, y, 0}, {x, y, 0}, {x, y, z}, {0, y, z});
    wall({0, 0, 0}, {0, y, 0}, {0, y, z}, {0, 0, z});
    wall({x, 0, 0}, {x, 0, z}, {x, y, z}, {x, y, 0});
    scene.luminaires.push_back(test::panel(scene, {2.0, 1.5, 2.0}, {1.0, 0.5}, 3000.0));
    const TrustReport report = report_of(scene);
    EXPECT_TRUE(report.solution->refusal.empty());
    EXPECT_EQ(report.energy.energy.absorbed, 0.0);
    EXPECT_NEAR(report.energy.energy.escaped, 3000.0, 60.0);
    EXPECT_EQ(report.energy.figure().state(), TrustState::holds) << report.energy.unexplained();
    EXPECT_EQ(report.closure.figure().state(), TrustState::holds) << report.closure.worst_deviation;
    EXPECT_TRUE(report.closure.rays_agree());
    EXPECT_LT(report.closure.seen_by_rays, 0.9);
}

TEST(Trust, gives_nothing_when_stopped) {
    std::stop_source stop;
    stop.request_stop();
    EXPECT_FALSE(trust_in(snapshot(test::small_office()), coarse_settings(), Work{.stop = stop.get_token()}));
}

}  // namespace
}  // namespace hanei
