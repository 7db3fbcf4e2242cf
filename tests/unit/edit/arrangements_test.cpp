#include "engine/edit/arrangements.h"

#include "engine/edit/luminaire_edits.h"
#include "engine/scene/scene_check.h"
#include "tests/unit/edit/luminaire_scenes.h"

#include <gtest/gtest.h>
#include <numbers>
#include <set>

namespace hanei {
namespace {

constexpr double rounding = 1e-12;

/// A field of 3 x 2 over the empty room of 6 m x 4 m.
Added field_of_six() {
    const Added lamp = test::hung(test::lobe(1.0));
    return arranged(lamp.scene, lamp.object, field_over_room(lamp.scene, 2.7, 3, 2));
}

const Arrangement& only(const Scene& scene) { return scene.arrangements.front(); }
Vec3 place(const Scene& scene, std::size_t k) { return find_luminaire(scene, only(scene).luminaires[k])->position; }

TEST(Arrangements, a_field_hangs_half_a_spacing_off_the_walls) {
    const Scene scene = field_of_six().scene;
    ASSERT_EQ(scene.luminaires.size(), 6U);
    EXPECT_LT(glm::length(place(scene, 0) - Vec3(1, 1, 2.7)), rounding);
    EXPECT_LT(glm::length(place(scene, 5) - Vec3(5, 3, 2.7)), rounding);
    std::set<std::string> names;
    for (const Luminaire& luminaire : scene.luminaires) names.insert(luminaire.name);
    EXPECT_EQ(names.size(), 6U) << "each has a name of its own";
    EXPECT_TRUE(check_scene(scene).empty());
    EXPECT_EQ(scene.photometries.size(), 1U);
}

TEST(Arrangements, more_columns_keep_what_is_set_of_each_luminaire_by_row_and_column) {
    Added field = field_of_six();
    Scene scene = field.scene;
    const ObjectId marked = only(scene).luminaires[4];  // row 1, column 1
    for (Luminaire& luminaire : scene.luminaires)
        if (luminaire.id == marked) luminaire.dimming = 0.25;
    scene = with_layout(std::move(scene), field.object, field_over_room(scene, 2.7, 4, 2), 0.0);
    ASSERT_EQ(scene.luminaires.size(), 8U);
    EXPECT_EQ(only(scene).luminaires[5], marked);
    EXPECT_EQ(find_luminaire(scene, marked)->dimming, 0.25);
    scene = with_layout(std::move(scene), field.object, field_over_room(scene, 2.7, 2, 1), 0.0);
    EXPECT_EQ(scene.luminaires.size(), 2U);
    EXPECT_TRUE(check_scene(scene).empty());
}

TEST(Arrangements, are_turned_as_a_whole_and_each_keeps_its_own_turn) {
    Added field = field_of_six();
    const ObjectId turned = only(field.scene).luminaires[2];
    for (Luminaire& luminaire : field.scene.luminaires)
        if (luminaire.id == turned) luminaire.yaw = 0.3;
    const Scene scene = with_layout(field.scene, field.object, only(field.scene).layout, 1.0);
    EXPECT_NEAR(find_luminaire(scene, turned)->yaw, 1.3, rounding);
    EXPECT_NEAR(find_luminaire(scene, only(scene).luminaires[0])->yaw, 1.0, rounding);
}

TEST(Arrangements, a_circle_may_face_outward) {
    const Added lamp = test::hung(test::lobe(1.0));
    const Added ring = arranged(lamp.scene, lamp.object, CircleLayout{{3, 2, 2.5}, 1.0, 4, 0.0, true});
    ASSERT_EQ(ring.scene.luminaires.size(), 4U);
    EXPECT_NEAR(find_luminaire(ring.scene, only(ring.scene).luminaires[1])->yaw, 0.5 * std::numbers::pi, rounding);
    EXPECT_LT(glm::length(place(ring.scene, 2) - Vec3(2, 2, 2.5)), rounding);
}

TEST(Arrangements, a_field_leaves_places_outside_an_l_shaped_room_empty_and_fills_them_when_it_grows) {
    Added lamp = test::hung(test::lobe(1.0));
    Room& room = *lamp.scene.room;
    room.plan = {{0, 0}, {6, 0}, {6, 2}, {3, 2}, {3, 4}, {0, 4}};
    room.wall_materials.resize(6, room.wall_materials.front());
    const Added field = arranged(lamp.scene, lamp.object, field_over_room(lamp.scene, 2.7, 4, 2));
    EXPECT_EQ(field.scene.luminaires.size(), 6U);
    EXPECT_EQ(places_outside(field.scene, only(field.scene)), 2U);
    Scene square = field.scene;
    square.room->plan = {{0, 0}, {6, 0}, {6, 4}, {0, 4}};
    square.room->wall_materials.resize(4);
    EXPECT_EQ(places_outside(square, only(square)), 0U);
    EXPECT_TRUE(check_scene(field.scene).empty());
}

TEST(Arrangements, a_luminaire_moved_by_itself_leaves_and_stays_away) {
    Added field = field_of_six();
    const ObjectId first = only(field.scene).luminaires[0];
    Scene scene = with_arrangements_kept(moved(field.scene, first, {0.2, 0.0, 0.0}));
    EXPECT_FALSE(only(scene).luminaires[0]);
    EXPECT_EQ(arrangement_of(scene, first), nullptr);
    scene = with_layout(std::move(scene), field.object, field_over_room(scene, 2.5, 3, 2), 0.0);
    EXPECT_EQ(luminaires_in(only(scene)), 5U) << "its place stays empty";
    EXPECT_EQ(find_luminaire(scene, first)->position.z, 2.7);
}

TEST(Arrangements, go_along_when_all_their_luminaires_are_moved_alike) {
    Added field = field_of_six();
    Scene scene = field.scene;
    for (Luminaire& luminaire : scene.luminaires) luminaire.position += Vec3(0.0, 0.1, -0.5);
    scene = with_arrangements_kept(std::move(scene));
    EXPECT_EQ(luminaires_in(only(scene)), 6U);
    EXPECT_LT(glm::length(std::get<FieldLayout>(only(scene).layout).corner - Vec3(0.0, 0.1, 2.2)), rounding);
    EXPECT_EQ(with_arrangements_kept(scene), scene);
}

TEST(Arrangements, move_with_their_luminaires_and_are_deleted_with_them) {
    Added field = field_of_six();
    const Scene scene = moved(field.scene, field.object, {0.5, 0.0, 0.0});
    EXPECT_LT(glm::length(place(scene, 0) - Vec3(1.5, 1.0, 2.7)), rounding);
    EXPECT_LT(glm::length(*place_of(scene, field.object) - Vec3(3.5, 2.0, 2.7)), rounding);
    const Scene gone = removed(field.scene, field.object);
    EXPECT_TRUE(gone.arrangements.empty());
    EXPECT_TRUE(gone.luminaires.empty());
    EXPECT_EQ(dissolved(field.scene, field.object).luminaires.size(), 6U);
    EXPECT_TRUE(dissolved(field.scene, field.object).arrangements.empty());
}

TEST(Arrangements, a_deleted_luminaire_leaves_its_place_empty_and_the_last_takes_the_arrangement_along) {
    Added field = field_of_six();
    Scene scene = removed(field.scene, only(field.scene).luminaires[3]);
    EXPECT_FALSE(only(scene).luminaires[3]);
    EXPECT_TRUE(check_scene(scene).empty());
    while (!scene.luminaires.empty()) scene = removed(scene, scene.luminaires.front().id);
    EXPECT_TRUE(scene.arrangements.empty());
}

TEST(Arrangements, degenerate_layouts_change_nothing) {
    Added field = field_of_six();
    EXPECT_EQ(with_layout(field.scene, field.object, LineLayout{{}, {}, 0}, 0.0), field.scene);
    EXPECT_EQ(with_layout(field.scene, field.object, FieldLayout{{90, 90, 2}, {1, 0, 0}, {0, 1, 0}, 2, 2}, 0.0),
              field.scene)
        << "none of it would hang in the room";
    EXPECT_EQ(with_layout(field.scene, ObjectId{999}, LineLayout{{}, {}, 2}, 0.0), field.scene);
}

TEST(LuminairesAmong, objects_are_those_of_arrangements_and_groups_each_once) {
    Added field = field_of_six();
    Scene scene = with_point_luminaire(field.scene).scene;
    const ObjectId point = scene.luminaires.back().id;
    const ObjectId both[] = {field.object, only(scene).luminaires[0]};
    EXPECT_EQ(luminaires_among(scene, both).size(), 6U);
    const ObjectId group = scene.new_id();
    scene.control_groups.push_back({group, "row", 1.0, 0.0, {}});
    scene.luminaires.back().group = group;
    const ObjectId by_group[] = {group, scene.room->id, ObjectId{}};
    EXPECT_EQ(luminaires_among(scene, by_group), (std::vector<ObjectId>{point}));
}

TEST(Arrangements, a_line_runs_along_the_room_s_longer_side) {
    const Scene room = empty_room();
    const auto line = std::get<LineLayout>(line_over_room(room, 2.5, 3));
    EXPECT_LT(glm::length(line.from - Vec3(1, 2, 2.5)), rounding);
    EXPECT_LT(glm::length(line.to - Vec3(5, 2, 2.5)), rounding);
}

}  // namespace
}  // namespace hanei
