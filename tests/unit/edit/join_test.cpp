#include "engine/edit/join.h"

#include "engine/edit/edit.h"
#include "engine/scene/scene_check.h"

#include <gtest/gtest.h>
#include <set>

namespace hanei {
namespace {

/// Its room with a box and a measured luminaire.
Scene furnished() {
    Scene scene = with_box(empty_room()).scene;
    Photometry photometry;
    photometry.name = "lamp";
    photometry.horizontal_deg = {0.0};
    photometry.vertical_deg = {0.0, 90.0};
    photometry.candela = {100.0, 0.0};
    return with_measured_luminaire(std::move(scene), photometry).scene;
}

TEST(Join, adds_everything_under_new_ids_and_uses_equal_materials_and_photometries_again) {
    const Scene scene = furnished();
    Scene other = furnished();
    other.room.reset();
    const Scene both = joined(scene, other);
    EXPECT_EQ(both.furniture.size(), 2U);
    EXPECT_EQ(both.luminaires.size(), 2U);
    EXPECT_EQ(both.materials, scene.materials);
    EXPECT_EQ(both.photometries.size(), 1U);
    EXPECT_EQ(both.luminaires[1].distribution, both.luminaires[0].distribution);
    EXPECT_EQ(both.room, scene.room);
    std::set<ObjectId> ids;
    for (const Furniture& each : both.furniture) EXPECT_TRUE(ids.insert(each.id).second);
    for (const Luminaire& each : both.luminaires) EXPECT_TRUE(ids.insert(each.id).second);
    EXPECT_FALSE(has_errors(check_scene(both)));
}

TEST(Join, lets_a_room_take_the_place_of_the_one_that_is_there) {
    Scene other = empty_room();
    other.room->height = 4.0;
    const Scene both = joined(furnished(), other);
    EXPECT_EQ(both.room->height, 4.0);
    EXPECT_EQ(both.furniture.size(), 1U);
    EXPECT_FALSE(has_errors(check_scene(both)));
}

TEST(Join, an_emptied_scene_gives_no_id_twice) {
    const Scene scene = furnished();
    const Scene empty = emptied(scene);
    EXPECT_TRUE(empty.furniture.empty() && empty.luminaires.empty() && !empty.room);
    EXPECT_EQ(empty.last_id, scene.last_id);
    EXPECT_EQ(empty.title, scene.title);
}

TEST(Join, furniture_stands_on_the_floor_with_its_middle_over_the_place) {
    Scene model = with_box(Scene{}).scene;
    model.furniture[0].position = {7.0, 8.0, 9.0};
    const Scene stood = stood_at(model, {1.0, 2.0}, 0.5);
    EXPECT_NEAR(glm::distance(stood.furniture[0].position, {1.0, 2.0, 0.5}), 0.0, 1e-12);
    EXPECT_EQ(stood_at(empty_room(), {1.0, 2.0}, 0.5), empty_room());
}

}  // namespace
}  // namespace hanei
