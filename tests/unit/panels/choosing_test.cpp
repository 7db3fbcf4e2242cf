#include "ui/panels/choosing.h"

#include <array>
#include <gtest/gtest.h>

namespace hanei {
namespace {

/// Two boxes side by side, seen from straight above to scale; the second and a lamp are a group.
struct Room {
    Scene scene = empty_room();
    ObjectId left, right, lamp, group;
    Pane pane{100.0F, 50.0F, 900.0F, 600.0F, {}};

    Room() {
        Added added = with_box(std::move(scene));
        left = added.object;
        added = with_box(moved(std::move(added.scene), added.object, {-1.5, 0.0, 0.0}));
        right = added.object;
        added = with_point_luminaire(moved(std::move(added.scene), right, {1.5, 0.0, 0.0}));
        lamp = added.object;
        scene = moved(std::move(added.scene), lamp, {1.5, 0.0, 0.0});
        ObjectGroup together;
        together.id = group = scene.new_id();
        together.members = {right, lamp};
        scene.object_groups.push_back(together);
        pane.camera = plan_view(bounds_of(scene), pane.aspect());
    }
    ImVec2 at(double x, double y, double z = 0.0) const { return *pane.on_screen(Vec3(x, y, z)); }
    Selection clicked(const Selection& before, ObjectId hit, ClickManner manner = {}) const {
        return chosen_by_click(scene, before, hit, manner);
    }
    ObjectIds boxed(ImVec2 from, ImVec2 to) const { return objects_in_box(scene, pane, from, to, false); }
};

TEST(AClick, chooses_one_and_with_shift_joins_or_leaves) {
    const Room room;
    const Selection one = room.clicked({}, room.left);
    EXPECT_EQ(one.ids(), ObjectIds{room.left});
    const Selection two = room.clicked(one, room.right, {true, true, false});
    EXPECT_EQ(two.ids(), (ObjectIds{room.left, room.right}));
    EXPECT_EQ(room.clicked(two, room.left, {true, false, false}).ids(), ObjectIds{room.right});
    EXPECT_EQ(room.clicked(two, {}, {true, false, false}), two) << "a missed click with Shift keeps them";
    EXPECT_TRUE(room.clicked(two, {}).empty());
}

TEST(AClick, on_a_member_chooses_its_group_until_the_group_is_entered) {
    const Room room;
    const Selection group = room.clicked({}, room.lamp);
    EXPECT_EQ(group.ids(), ObjectIds{room.group});
    EXPECT_EQ(room.clicked({}, room.lamp, {false, true, false}).ids(), ObjectIds{room.lamp}) << "Alt";
    const Selection entered = room.clicked(group, room.lamp, {false, false, true});
    EXPECT_EQ(entered.ids(), ObjectIds{room.lamp}) << "a double click";
    EXPECT_EQ(room.clicked(entered, room.right).ids(), ObjectIds{room.right}) << "within it a click is enough";
    EXPECT_EQ(room.clicked(room.clicked(entered, room.left), room.right).ids(), ObjectIds{room.group});
}

TEST(ABox, to_the_right_takes_what_it_encloses_and_to_the_left_what_it_touches) {
    const Room room;
    const Vec3 box = *place_of(room.scene, room.left);
    const ImVec2 outside = room.at(box.x - 0.9, box.y + 0.6);
    const ImVec2 beyond = room.at(box.x + 0.9, box.y - 0.6);
    const ImVec2 halfway = room.at(box.x, box.y - 0.6);
    EXPECT_EQ(room.boxed(outside, beyond), ObjectIds{room.left});
    EXPECT_EQ(room.boxed(outside, halfway), ObjectIds{});
    EXPECT_EQ(room.boxed(halfway, outside), ObjectIds{room.left});
    EXPECT_EQ(room.boxed(room.at(box.x + 0.1, box.y), room.at(box.x, box.y + 0.1)), ObjectIds{room.left})
        << "a box within an object touches it";
    EXPECT_EQ(room.boxed(room.at(0.1, 0.1), room.at(0.2, 0.2)), ObjectIds{});
}

TEST(ABox, chooses_the_group_of_what_it_takes) {
    const Room room;
    const ObjectIds all = room.boxed(room.at(-1.0, 5.0), room.at(7.0, -1.0));
    EXPECT_EQ(all.size(), 3U);
    EXPECT_EQ(chosen_by_box(room.scene, {}, all, BoxManner::replaces).ids(), (ObjectIds{room.left, room.group}));
    const Selection before(room.left);
    EXPECT_EQ(chosen_by_box(room.scene, before, {room.lamp}, BoxManner::adds).ids(),
              (ObjectIds{room.left, room.group}));
    EXPECT_TRUE(chosen_by_box(room.scene, before, {room.left}, BoxManner::takes).empty());
}

TEST(ARange, of_rows_holds_both_ends_in_either_direction) {
    const ObjectIds rows{ObjectId{3}, ObjectId{1}, ObjectId{7}, ObjectId{2}};
    EXPECT_EQ(rows_between(rows, ObjectId{1}, ObjectId{2}), (ObjectIds{ObjectId{1}, ObjectId{7}, ObjectId{2}}));
    EXPECT_EQ(rows_between(rows, ObjectId{7}, ObjectId{3}), (ObjectIds{ObjectId{3}, ObjectId{1}, ObjectId{7}}));
    EXPECT_EQ(rows_between(rows, ObjectId{9}, ObjectId{3}), ObjectIds{ObjectId{3}}) << "the first is gone";
}

}  // namespace
}  // namespace hanei
