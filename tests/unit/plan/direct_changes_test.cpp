#include "engine/plan/direct_changes.h"

#include "engine/plan/plan.h"
#include "tests/unit/mesh/sample_scenes.h"

#include <cmath>
#include <gtest/gtest.h>

namespace hanei {
namespace {

Luminaire panel(Scene& scene, const Vec3& position) {
    Luminaire made;
    made.id = scene.new_id();
    made.position = position;
    made.output = LuminousFlux{3000.0};
    made.opening = PolygonOpening{{{{-0.3, -0.3, 0}, {-0.3, 0.3, 0}, {0.3, 0.3, 0}, {0.3, -0.3, 0}}, {}}};
    return made;
}

const Receiver under_the_table{{3.0, 2.0, 0.3}, {0.0, 0.0, 1.0}, Vec3{0.0}};
const Receiver far_from_it{{0.5, 0.5, 0.75}, {0.0, 0.0, 1.0}, Vec3{0.0}};

TEST(DirectChanges, of_shadows_are_all_light_that_furniture_may_hide_and_none_of_other) {
    Scene scene = sample::box_room(6.0, 4.0, 2.8, 0.6);
    scene.luminaires.push_back(panel(scene, {3.0, 2.0, 2.7}));
    const Receiver places[] = {under_the_table, far_from_it};
    const DirectChanges empty = direct_changes(scene, places);
    EXPECT_EQ(empty.shadows, (std::vector{0.0, 0.0}));
    sample::add_box(scene, {3.0, 2.0, 0.7}, {1.2, 0.8, 0.04}, 0.0, 0.5);
    const DirectChanges changes = direct_changes(scene, places);
    EXPECT_GT(changes.shadows[0], 100.0);
    EXPECT_EQ(changes.penumbra[0], changes.shadows[0]);
    EXPECT_EQ(changes.shadows[1], 0.0);
    EXPECT_EQ(changes.openings, (std::vector{0.0, 0.0}));
    scene.luminaires[0].opening = PointOpening{};
    EXPECT_EQ(direct_changes(scene, places).penumbra[0], 0.0) << "a point has no penumbra";
    scene.luminaires[0].dimming = 0.0;
    EXPECT_EQ(direct_changes(scene, places).shadows[0], 0.0);
}

TEST(DirectChanges, of_openings_fall_with_the_distance_and_are_certified_where_nothing_is_in_the_way) {
    Scene scene = sample::box_room(60.0, 40.0, 28.0, 0.6);
    Photometry cosine;
    cosine.id = scene.new_id();
    cosine.symmetry = PhotometricSymmetry::rotational;
    cosine.horizontal_deg = {0.0};
    for (double gamma = 0.0; gamma <= 90.0; gamma += 5.0) {
        cosine.vertical_deg.push_back(gamma);
        cosine.candela.push_back(1000.0 * std::max(0.0, std::cos(gamma * 3.14159265358979 / 180.0)));
    }
    cosine.opening = {OpeningShape::rectangle, 0.6, 0.6, 0.0};
    scene.photometries.push_back(cosine);
    Luminaire measured = panel(scene, {30.0, 20.0, 27.0});
    measured.opening = MeasuredOpening{};
    measured.distribution = Measured{cosine.id};
    measured.output = AsMeasured{};
    scene.luminaires.push_back(measured);
    const Receiver places[] = {{{30.0, 20.0, 26.0}, {0.0, 0.0, 1.0}, {}},
                               {{30.0, 20.0, 22.0}, {0.0, 0.0, 1.0}, {}},
                               {{30.0, 20.0, 7.0}, {0.0, 0.0, 1.0}, {}}};
    const std::vector<double> openings = direct_changes(scene, places).openings;
    EXPECT_GT(openings[0], openings[1]);
    EXPECT_GT(openings[1], openings[2]);
    EXPECT_GT(openings[2], 0.0);
    EXPECT_LT(openings[2], 0.05 * 1000.0 / 400.0) << "of 2.5 lx";
    sample::add_box(scene, {30.0, 20.0, 23.0}, {1.2, 0.8, 0.04}, 0.0, 0.5);
    EXPECT_GT(direct_changes(scene, places).openings[1], 10.0 * openings[1]) << "a shadow of a point or of an opening";
}

TEST(DirectChanges, stand_in_the_plan_at_every_point) {
    Scene scene = sample::box_room(6.0, 4.0, 2.8, 0.6);
    scene.luminaires.push_back(panel(scene, {3.0, 2.0, 2.7}));
    sample::add_box(scene, {3.0, 2.0, 0.7}, {1.2, 0.8, 0.04}, 0.0, 0.5);
    for (const Receiver& place : {under_the_table, far_from_it})
        scene.points.push_back({scene.new_id(), "", place.position, place.normal, {}});
    const EffectsPlan plan = plan_effects(scene, {});
    const PlannedEffect& between = plan.row(Effect::interreflection);
    for (const Effect effect : {Effect::occlusion_direct, Effect::penumbra, Effect::occlusion_patches}) {
        const PlannedEffect& row = plan.row(effect);
        ASSERT_EQ(row.bound_at_points.size(), 2U) << name_of(effect);
        EXPECT_EQ(row.bound_lux, std::max(row.bound_at_points[0], row.bound_at_points[1]));
        EXPECT_FALSE(row.may_be_skipped);
    }
    EXPECT_EQ(plan.row(Effect::occlusion_patches).bound_at_points, between.bound_at_points);
    EXPECT_TRUE(plan_effects(scene, {}, PlanDetail::decisions).row(Effect::penumbra).bound_at_points.empty());
}

}  // namespace
}  // namespace hanei
