#include "engine/edit/aiming.h"

#include "engine/edit/luminaire_edits.h"
#include "engine/edit/mounting.h"
#include "engine/scene/placement.h"
#include "engine/scene/suspension.h"
#include "tests/unit/edit/luminaire_scenes.h"

#include <gtest/gtest.h>
#include <numbers>

namespace hanei {
namespace {

constexpr double pi = std::numbers::pi;

/// The angle between the luminaire's main beam and the way to the target, rad.
double missed_by(const Scene& scene, const Luminaire& luminaire, const Vec3& target) {
    const Vec3 way = glm::normalize(target - luminaire.position);
    return std::acos(std::min(1.0, glm::dot(way, beam_in_scene(scene, luminaire))));
}

TEST(Aiming, every_luminaire_is_turned_until_its_beam_meets_the_target) {
    constexpr double as_exact_as_a_cosine = 1e-7;  // rad
    for (const auto& [towards, plane] : {std::pair{0.0, 0.0}, {0.6, 0.0}, {0.6, 90.0}, {0.5, 45.0}, {1.2, 250.0}}) {
        const Added lamp = test::hung(test::lobe(20.0, towards, plane));
        for (const Vec3& target :
             {Vec3(1, 1, 0), Vec3(5.5, 3.5, 0.75), Vec3(3, 2, 0), Vec3(0, 2, 2.5), Vec3(3, 0, 1), Vec3(4, 2, 2.8)}) {
            const Luminaire aimed_lamp = aimed(lamp.scene, lamp.scene.luminaires[0], target);
            EXPECT_LT(missed_by(lamp.scene, aimed_lamp, target), as_exact_as_a_cosine)
                << "beam " << towards << " in C" << plane << " to " << target.x << ' ' << target.y << ' ' << target.z;
        }
    }
}

TEST(Aiming, a_symmetric_luminaire_is_only_tilted_and_turned) {
    const Added lamp = test::hung(test::lobe(3.0));
    const Luminaire there = aimed(lamp.scene, lamp.scene.luminaires[0], {6.0, 2.0, 0.0});
    EXPECT_EQ(there.roll, 0.0);
    EXPECT_NEAR(there.yaw, 0.0, 1e-9);
    EXPECT_NEAR(there.tilt, std::atan2(3.0, there.position.z), 1e-9);
}

TEST(Aiming, straight_down_keeps_the_turn_about_the_vertical) {
    Added lamp = test::hung(test::lobe(3.0));
    lamp.scene.luminaires[0].yaw = 0.7;
    const Luminaire there = aimed(lamp.scene, lamp.scene.luminaires[0], {3.0, 2.0, 0.0});
    EXPECT_EQ(there.yaw, 0.7);
    EXPECT_NEAR(there.tilt, 0.0, 1e-9);
}

TEST(Aiming, at_the_luminaire_s_own_place_changes_nothing) {
    const Added lamp = test::hung(test::lobe(3.0));
    const Luminaire& hung = lamp.scene.luminaires[0];
    EXPECT_EQ(aimed(lamp.scene, hung, hung.position), hung);
}

TEST(Aiming, the_main_beam_of_any_luminaire_is_a_direction) {
    Scene scene = with_panel_luminaire(empty_room()).scene;
    EXPECT_EQ(main_beam(scene, scene.luminaires[0]), Vec3(0, 0, -1));
    scene = with_point_luminaire(empty_room()).scene;
    EXPECT_EQ(main_beam(scene, scene.luminaires[0]), Vec3(0, 0, -1)) << "alike to all sides";
    scene = test::hung(test::lobe(8.0, pi)).scene;
    EXPECT_EQ(main_beam(scene, scene.luminaires[0]), Vec3(0, 0, 1)) << "it shines up";
}

TEST(Mounting, at_the_ceiling_is_flush_below_it_by_a_housing_or_by_a_suspension) {
    const Added lamp = test::hung(test::lobe(1.0));
    const ObjectId ids[] = {lamp.object};
    const auto z_of = [&](const MountingWish& wish) {
        const Scene scene = mounted(lamp.scene, ids, wish);
        EXPECT_EQ(mounting_of(scene, scene.luminaires[0]).mounting, wish.mounting) << name_of(wish.mounting);
        return scene.luminaires[0].position.z;
    };
    EXPECT_GT(z_of({Mounting::recessed}), 2.79);
    EXPECT_NEAR(z_of({Mounting::surface}), 2.72, 1e-9);
    EXPECT_NEAR(z_of({Mounting::pendant, 0.6}), 2.2, 1e-9);
    EXPECT_NEAR(z_of({Mounting::standing, 0.0, 1.2}), 1.2, 1e-9);
}

TEST(Mounting, on_the_wall_a_downlight_looks_into_the_room) {
    const Added lamp = test::hung(test::lobe(4.0));
    Scene scene = moved(lamp.scene, lamp.object, {2.0, 0.3, 0.0});  // nearest to the wall at x = 6
    const ObjectId ids[] = {lamp.object};
    scene = mounted(std::move(scene), ids, {Mounting::wall, 0.5, 1.7});
    const Luminaire& hung = scene.luminaires[0];
    EXPECT_NEAR(hung.position.z, 1.7, 1e-9);
    EXPECT_NEAR(hung.position.x, 6.0, 0.01);
    EXPECT_LT(hung.position.x, 6.0);
    EXPECT_LT(glm::length(beam_in_scene(scene, hung) - Vec3(-1, 0, 0)), 1e-9);
    EXPECT_EQ(mounting_of(scene, hung).mounting, Mounting::wall);
}

TEST(Mounting, on_the_wall_a_one_sided_luminaire_stays_upright_and_turns_its_side_to_the_room) {
    const Added lamp = test::hung(test::lobe(4.0, 0.7, 90.0));
    Scene scene = moved(lamp.scene, lamp.object, {0.0, -1.5, 0.0});  // nearest to the wall at y = 0
    const ObjectId ids[] = {lamp.object};
    scene = mounted(std::move(scene), ids, {Mounting::wall, 0.5, 2.0});
    const Luminaire& hung = scene.luminaires[0];
    EXPECT_EQ(hung.tilt, 0.0);
    EXPECT_GT(beam_in_scene(scene, hung).y, 0.5);
    EXPECT_GT(hung.position.y, 0.1) << "its opening is 0.3 m deep";
}

TEST(Mounting, keeps_luminaires_within_the_room) {
    const Added lamp = test::hung(test::lobe(1.0));
    const ObjectId ids[] = {lamp.object};
    for (const Mounting mounting : mountings) {
        const Scene scene = mounted(lamp.scene, ids, {mounting, 50.0, 50.0});
        const double z = scene.luminaires[0].position.z;
        EXPECT_GT(z, 0.0) << name_of(mounting);
        EXPECT_LT(z, 2.8) << name_of(mounting);
    }
    Scene roomless = lamp.scene;
    roomless.room.reset();
    EXPECT_EQ(mounted(roomless, ids, {Mounting::wall}), roomless);
}

TEST(Suspension, is_drawn_for_pendants_only) {
    const Added lamp = test::hung(test::lobe(1.0));
    const ObjectId ids[] = {lamp.object};
    for (const Mounting mounting : mountings) {
        const Scene scene = mounted(lamp.scene, ids, {mounting, 0.7, 1.0});
        const auto cord = suspension_of(scene, scene.luminaires[0]);
        EXPECT_EQ(cord.has_value(), mounting == Mounting::pendant) << name_of(mounting);
        if (!cord) continue;
        EXPECT_NEAR(glm::length(cord->second - cord->first), 0.7, 1e-9);
    }
}

}  // namespace
}  // namespace hanei
