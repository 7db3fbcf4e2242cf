#include "engine/plan/plan.h"
#include "tests/unit/mesh/sample_scenes.h"

#include <gtest/gtest.h>

namespace hanei {
namespace {

/// A room with a panel, a big bright cabinet and a speck far from the one point.
struct Furnished {
    Scene scene = sample::box_room(6.0, 4.0, 2.8, 0.6);
    ObjectId cabinet, speck;

    Furnished() {
        cabinet = sample::add_box(scene, {3.0, 2.0, 0.0}, {1.0, 0.6, 1.8}, 0.0, 0.7);
        speck = sample::add_box(scene, {5.5, 3.5, 0.0}, {0.02, 0.02, 0.02}, 0.0, 0.7);
        Luminaire panel;
        panel.id = scene.new_id();
        panel.position = {3.0, 1.0, 2.7};
        panel.output = LuminousFlux{3000.0};
        panel.opening = PolygonOpening{{{{-0.3, -0.3, 0}, {-0.3, 0.3, 0}, {0.3, 0.3, 0}, {0.3, -0.3, 0}}, {}}};
        scene.luminaires.push_back(panel);
        scene.points.push_back({scene.new_id(), "desk", {1.0, 1.0, 0.75}, {0.0, 0.0, 1.0}, {}});
    }
    PlannedPiece piece(ObjectId id, const Settings& settings) const {
        const EffectsPlan plan = plan_effects(scene, settings);
        for (const PlannedPiece& each : plan.row(Effect::furniture).pieces)
            if (each.object == id) return each;
        return {};
    }
};

TEST(Skipping, takes_the_speck_as_black_and_leaves_the_cabinet) {
    const Furnished room;
    const double of_speck = room.piece(room.speck, {}).bound_lux;
    const double of_cabinet = room.piece(room.cabinet, {}).bound_lux;
    EXPECT_GT(of_speck, 0.0);
    EXPECT_LT(of_speck, 1.0);
    EXPECT_GT(of_cabinet, 20.0 * of_speck);
    Settings settings;
    settings.tolerance_lux = 1.5 * of_speck;
    const EffectsPlan plan = plan_effects(room.scene, settings);
    EXPECT_EQ(plan.black, std::vector{room.speck});
    EXPECT_EQ(room.piece(room.speck, settings).state, EffectState::skipped);
    EXPECT_EQ(room.piece(room.cabinet, settings).state, EffectState::simulated);
    EXPECT_TRUE(plan.simulates(Effect::furniture));
    EXPECT_NEAR(plan.skipped_lux, of_speck, 1e-9);
    EXPECT_EQ(plan.row(Effect::furniture).bound_at_points.size(), 1U);
}

TEST(Skipping, never_leaves_out_more_than_the_tolerance_and_decides_alike_at_both_details) {
    const Furnished room;
    for (const double tolerance : {0.0, 0.01, 1.0, 50.0, 2000.0}) {
        Settings settings;
        settings.tolerance_lux = tolerance;
        const EffectsPlan plan = plan_effects(room.scene, settings);
        EXPECT_LE(plan.skipped_lux, tolerance);
        const EffectsPlan quick = plan_effects(room.scene, settings, PlanDetail::decisions);
        EXPECT_EQ(plan.black, quick.black) << tolerance;
        for (std::size_t k = 0; k < plan.effects.size(); ++k)
            EXPECT_EQ(plan.effects[k].state, quick.effects[k].state) << tolerance;
    }
}

TEST(Skipping, does_as_the_user_says) {
    const Furnished room;
    Settings settings;
    settings.tolerance_lux = 1e5;
    EXPECT_EQ(plan_effects(room.scene, settings).row(Effect::interreflection).state, EffectState::skipped);
    settings.interreflection = EffectChoice::always;
    settings.furniture = EffectChoice::always;
    EXPECT_TRUE(plan_effects(room.scene, settings).simulates(Effect::interreflection));
    EXPECT_TRUE(plan_effects(room.scene, settings).black.empty());
    settings.tolerance_lux = 0.0;
    settings.furniture = EffectChoice::never;
    const EffectsPlan plan = plan_effects(room.scene, settings);
    EXPECT_EQ(plan.black.size(), 2U);
    EXPECT_EQ(plan.row(Effect::furniture).state, EffectState::skipped);
    EXPECT_GT(plan.skipped_lux, 0.0);
    EXPECT_GE(plan.skipped_anywhere_lux, plan.skipped_lux);
    const double there = plan.skipped_at({1.0, 1.0, 0.75}, {0.0, 0.0, 1.0});
    EXPECT_GT(there, 0.0);
    EXPECT_NEAR(there, plan.skipped_lux, 0.05 * plan.skipped_lux);  // pieces bounded together, or one by one
}

TEST(Skipping, a_bound_falls_with_the_distance_and_is_greatest_at_the_piece) {
    const Furnished room;
    Settings settings;
    settings.furniture = EffectChoice::never;
    const EffectsPlan plan = plan_effects(room.scene, settings);
    const Vec3 away{-1.0, 0.0, 0.0};  // of a receiver that looks at the cabinet
    const double near = plan.skipped_at({2.4, 2.0, 1.0}, -away), far = plan.skipped_at({0.4, 2.0, 1.0}, -away);
    EXPECT_GT(near, 1.3 * far);
    EXPECT_LE(near, plan.skipped_anywhere_lux * 1.0001);
}

}  // namespace
}  // namespace hanei
