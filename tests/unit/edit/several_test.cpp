#include "engine/edit/excerpt.h"
#include "engine/scene/scene_check.h"

#include <array>
#include <gtest/gtest.h>
#include <numbers>

namespace hanei {
namespace {

constexpr double rounding = 1e-12;  // m, of a few additions and a turn at the size of a room

/// Three luminaires in a row as one arrangement, and a desk with a lamp on it as a group.
struct Desk {
    Scene scene = empty_room();
    ObjectIds row;
    ObjectId arrangement, box, lamp, group;

    Desk() {
        for (int k = 0; k < 3; ++k) {
            Added added = with_panel_luminaire(std::move(scene));
            scene = moved(std::move(added.scene), added.object, {k - 1.0, 0.0, 0.0});
            row.push_back(added.object);
        }
        Arrangement line;
        line.id = arrangement = scene.new_id();
        line.name = "Row";
        line.layout = LineLayout{*place_of(scene, row.front()), *place_of(scene, row.back()), 3};
        line.luminaires = row;
        scene.arrangements.push_back(line);
        Added added = with_box(std::move(scene));
        box = added.object;
        added = with_point_luminaire(std::move(added.scene));
        lamp = added.object;
        scene = std::move(added.scene);
        ObjectGroup together;
        together.id = group = scene.new_id();
        together.name = "Desk with lamp";
        together.members = {box, lamp};
        scene.object_groups.push_back(together);
    }
    const Arrangement& line() const { return scene.arrangements.front(); }
};

TEST(Several, a_group_is_moved_with_all_its_members) {
    const Desk desk;
    const Scene after = moved(desk.scene, std::array{desk.group}, {0.5, 0.25, 0.0});
    for (const ObjectId id : {desk.box, desk.lamp})
        EXPECT_EQ(*place_of(after, id), *place_of(desk.scene, id) + Vec3(0.5, 0.25, 0.0));
    EXPECT_EQ(after.luminaires.front(), desk.scene.luminaires.front());
}

TEST(Several, an_arrangement_moves_along_when_all_its_luminaires_do) {
    const Desk desk;
    const Scene after = moved(desk.scene, desk.row, {0.0, 1.0, 0.0});
    const auto& before = std::get<LineLayout>(desk.line().layout);
    const auto& line = std::get<LineLayout>(after.arrangements.front().layout);
    EXPECT_EQ(line.from, before.from + Vec3(0.0, 1.0, 0.0));
    EXPECT_EQ(line.to, before.to + Vec3(0.0, 1.0, 0.0));
    EXPECT_EQ(after.arrangements.front().luminaires, desk.row);
    EXPECT_EQ(moved(desk.scene, std::array{desk.arrangement}, {0.0, 1.0, 0.0}), after);
}

TEST(Several, a_luminaire_moved_without_the_others_leaves_its_arrangement) {
    const Desk desk;
    const Scene after = moved(desk.scene, desk.row[1], {0.0, 1.0, 0.0});
    EXPECT_EQ(after.arrangements.front().luminaires, (ObjectIds{desk.row[0], {}, desk.row[2]}));
    EXPECT_EQ(after.arrangements.front().layout, desk.line().layout);
}

TEST(Several, four_quarter_turns_about_their_middle_lead_back) {
    const Desk desk;
    ObjectIds all = desk.row;
    all.push_back(desk.group);
    const Vec3 middle = *middle_of(desk.scene, all);
    Scene scene = desk.scene;
    for (int k = 0; k < 4; ++k) scene = turned(scene, all, middle, 0.5 * std::numbers::pi);
    for (const ObjectId id : objects_of(desk.scene, all))
        EXPECT_NEAR(glm::length(*place_of(scene, id) - *place_of(desk.scene, id)), 0.0, 10.0 * rounding);
    const Scene once = turned(desk.scene, all, middle, 0.5 * std::numbers::pi);
    EXPECT_NEAR(once.furniture.front().rotation, 0.5 * std::numbers::pi, rounding);
    const Vec3 before = *place_of(desk.scene, desk.row[0]) - middle;
    const Vec3 after = *place_of(once, desk.row[0]) - middle;
    EXPECT_NEAR(after.x, -before.y, rounding);
    EXPECT_NEAR(after.y, before.x, rounding);
}

TEST(Several, removing_a_group_removes_its_members_and_keeps_the_rest) {
    const Desk desk;
    const Scene after = removed(desk.scene, std::array{desk.group});
    EXPECT_TRUE(after.furniture.empty());
    EXPECT_TRUE(after.object_groups.empty());
    EXPECT_EQ(after.luminaires.size(), 3U);
    EXPECT_EQ(after.arrangements, desk.scene.arrangements);
    EXPECT_FALSE(can_remove(desk.scene, std::array{desk.scene.room->id}));
}

TEST(Several, are_called_by_what_they_are) {
    const Desk desk;
    EXPECT_EQ(words_for(desk.scene, desk.row), "3 luminaires");
    EXPECT_EQ(words_for(desk.scene, std::array{desk.row[0]}), "luminaire");
    EXPECT_EQ(words_for(desk.scene, std::array{desk.row[0], desk.box}), "2 objects");
    EXPECT_EQ(words_for(desk.scene, std::array{desk.group}), "group");
}

TEST(Several, of_a_kind_are_found_by_one_of_them) {
    const Desk desk;
    EXPECT_EQ(same_kind(desk.scene, std::array{desk.lamp}).size(), 4U);
    EXPECT_EQ(same_kind(desk.scene, std::array{desk.box}), ObjectIds{desk.box});
    const ObjectIds all = all_objects(desk.scene);
    EXPECT_EQ(all.size(), 4U) << "a group stands for its members";
}

TEST(ACopy, of_a_group_and_an_arrangement_is_a_group_and_an_arrangement_of_copies) {
    const Desk desk;
    const AddedSeveral copy = duplicated(desk.scene, std::array{desk.group, desk.arrangement});
    EXPECT_FALSE(has_errors(check_scene(copy.scene)));
    ASSERT_EQ(copy.scene.object_groups.size(), 2U);
    ASSERT_EQ(copy.scene.arrangements.size(), 2U);
    EXPECT_EQ(copy.scene.luminaires.size(), 8U);
    EXPECT_EQ(copy.objects.size(), 4U) << "three luminaires and the group";
    for (const ObjectId id : copy.scene.object_groups[1].members) EXPECT_EQ(kind_of(desk.scene, id), ObjectKind::none);
    EXPECT_EQ(copy.scene.object_groups[1].name, "Desk with lamp 2");
    EXPECT_EQ(removed(removed(copy.scene, copy.objects), copy.scene.arrangements[1].id).furniture,
              desk.scene.furniture);
}

TEST(ACopy, takes_along_the_materials_it_needs_and_uses_equal_ones_again) {
    const Desk desk;
    const Scene alone = excerpt(desk.scene, std::array{desk.box});
    EXPECT_EQ(alone.materials.size(), 1U);
    EXPECT_FALSE(alone.room);
    const AddedSeveral same = with_excerpt(desk.scene, alone, Vec3{1.0, 0.0, 0.0});
    EXPECT_EQ(same.scene.materials, desk.scene.materials);
    Scene other = empty_room();
    other.materials[2].reflectance = 0.123;
    const AddedSeveral pasted = with_excerpt(other, alone, Vec3{0.0});
    EXPECT_FALSE(has_errors(check_scene(pasted.scene)));
    const ObjectId material = pasted.scene.furniture.front().parts.front().material;
    EXPECT_EQ(find_material(pasted.scene, material)->reflectance, alone.materials.front().reflectance);
}

TEST(ACopy, gets_the_next_free_number) {
    Scene scene = with_box(empty_room()).scene;
    EXPECT_EQ(free_name(scene, "Box 1"), "Box 2");
    EXPECT_EQ(free_name(scene, "Shelf"), "Shelf");
    scene.furniture.front().name = "Shelf";
    EXPECT_EQ(free_name(scene, "Shelf"), "Shelf 2");
    scene.furniture.front().name = "Shelf 99999999999999999999";
    EXPECT_EQ(free_name(scene, "Shelf 99999999999999999999"), "Shelf 99999999999999999999 2");
    EXPECT_EQ(free_name(scene, ""), "");
}

}  // namespace
}  // namespace hanei
