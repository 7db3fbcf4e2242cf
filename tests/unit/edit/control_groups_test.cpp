#include "engine/edit/control_groups.h"

#include "engine/scene/scene_check.h"

#include <gtest/gtest.h>

namespace hanei {
namespace {

/// An empty room with four lamps, two of them in "Group 1", the others in "Group 2".
Scene two_groups() {
    Scene scene = empty_room();
    for (int k = 0; k < 4; ++k) scene = with_point_luminaire(std::move(scene)).scene;
    const std::vector<ObjectId> first{scene.luminaires[0].id, scene.luminaires[1].id};
    const std::vector<ObjectId> second{scene.luminaires[2].id, scene.luminaires[3].id};
    scene = with_control_group(std::move(scene), first).scene;
    return with_control_group(std::move(scene), second).scene;
}

TEST(ControlGroups, a_new_one_takes_the_luminaires_and_a_free_name) {
    Scene scene = two_groups();
    EXPECT_EQ(scene.control_groups[0].name, "Group 1");
    EXPECT_EQ(scene.control_groups[1].name, "Group 2");
    EXPECT_EQ(members_of(scene, scene.control_groups[0].id), 2);
    scene = removed(std::move(scene), scene.control_groups[0].id);
    EXPECT_EQ(members_of(scene, {}), 2) << "they have no group any longer";
    const std::vector<ObjectId> one{scene.luminaires[0].id};
    const Added added = with_control_group(scene, one);
    EXPECT_EQ(find_control_group(added.scene, added.object)->name, "Group 3") << "Group 2 is taken";
    EXPECT_EQ(members_of(added.scene, added.object), 1);
}

TEST(ControlGroups, a_luminaire_is_given_to_another_group_or_to_none) {
    Scene scene = two_groups();
    const std::vector<ObjectId> all{scene.luminaires[0].id, scene.luminaires[3].id, scene.room->id};
    scene = with_group_of(std::move(scene), all, scene.control_groups[1].id);
    EXPECT_EQ(members_of(scene, scene.control_groups[1].id), 3);
    scene = with_group_of(std::move(scene), all, {});
    EXPECT_EQ(members_of(scene, {}), 2);
}

TEST(ControlGroups, dimmers_stay_within_off_and_full) {
    Scene scene = two_groups();
    scene = dimmed(std::move(scene), scene.control_groups[0].id, 1.7);
    EXPECT_EQ(scene.control_groups[0].dimming, 1.0);
    scene = dimmed(std::move(scene), scene.control_groups[0].id, -0.1);
    EXPECT_EQ(scene.control_groups[0].dimming, 0.0);
}

TEST(ControlGroups, one_alone_is_on_and_all_others_are_off) {
    Scene scene = two_groups();
    scene = dimmed(std::move(scene), scene.control_groups[0].id, 0.3);
    scene = alone(std::move(scene), scene.control_groups[0].id);
    EXPECT_EQ(scene.control_groups[0].dimming, 0.3);
    EXPECT_EQ(scene.control_groups[1].dimming, 0.0);
    scene = alone(std::move(scene), scene.control_groups[1].id);
    EXPECT_EQ(scene.control_groups[0].dimming, 0.0);
    EXPECT_EQ(scene.control_groups[1].dimming, 1.0) << "it was off";
    EXPECT_EQ(alone(scene, ObjectId{}), scene);
}

TEST(LightScenes, recall_the_dimmers_they_were_stored_with) {
    Scene scene = two_groups();
    scene = dimmed(std::move(scene), scene.control_groups[0].id, 0.2);
    const Added stored = with_light_scene(std::move(scene));
    EXPECT_EQ(find_light_scene(stored.scene, stored.object)->name, "Light scene 1");
    EXPECT_TRUE(is_recalled(stored.scene, stored.scene.light_scenes[0]));
    Scene other = dimmed(stored.scene, stored.scene.control_groups[0].id, 0.9);
    other = dimmed(std::move(other), stored.scene.control_groups[1].id, 0.1);
    EXPECT_FALSE(is_recalled(other, other.light_scenes[0]));
    EXPECT_EQ(recalled(other, stored.object), stored.scene);
    other = with_stored_levels(std::move(other), stored.object);
    EXPECT_TRUE(is_recalled(other, other.light_scenes[0]));
    EXPECT_TRUE(check_scene(other).empty());
}

TEST(LightScenes, leave_groups_alone_that_they_do_not_name) {
    Scene scene = with_light_scene(two_groups()).scene;
    scene = removed(std::move(scene), scene.control_groups[0].id);
    ASSERT_EQ(scene.light_scenes[0].levels.size(), 1U);
    scene = dimmed(std::move(scene), scene.control_groups[0].id, 0.5);
    EXPECT_EQ(recalled(scene, scene.light_scenes[0].id).control_groups[0].dimming, 1.0);
    EXPECT_EQ(recalled(scene, ObjectId{9999}), scene);
}

TEST(LightScenes, that_name_no_group_are_never_the_present_one) {
    const Added empty = with_light_scene(empty_room());
    EXPECT_FALSE(is_recalled(empty.scene, empty.scene.light_scenes[0]));
}

}  // namespace
}  // namespace hanei
