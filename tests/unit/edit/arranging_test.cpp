#include "engine/edit/aligning.h"
#include "engine/edit/copies.h"
#include "engine/edit/furniture_edits.h"
#include "engine/edit/standing.h"
#include "engine/edit/sub_areas.h"
#include "engine/scene/scene_check.h"

#include <array>
#include <gtest/gtest.h>
#include <numbers>
#include <random>

namespace hanei {
namespace {

constexpr double rounding = 1e-9;  // m: places are kept to the nanometre

/// A room of 12 m x 8 m.
Scene hall() {
    Scene scene = empty_room();
    scene.room->plan = {{0.0, 0.0}, {12.0, 0.0}, {12.0, 8.0}, {0.0, 8.0}};
    return scene;
}

void expect_sound(const Scene& scene) {
    for (const Diagnostic& finding : check_scene(scene))
        EXPECT_EQ(finding.severity, Severity::note) << to_text(finding);
}

Bounds bounds(const Scene& scene, ObjectId id) { return *bounds_of_objects(scene, std::array{id}); }

TEST(AnArray, has_rows_and_columns_at_its_spacings_with_the_original_first) {
    const Added desk = with_furniture(hall(), {"desk", {}}, {1.0, 1.0, 0.0});
    const AddedSeveral all = arrayed(desk.scene, std::array{desk.object}, {4, 3, {2.0, 0.0, 0.0}, {0.0, 2.5, 0.0}});
    EXPECT_EQ(all.objects.size(), 12U);
    EXPECT_EQ(all.objects.front(), desk.object);
    EXPECT_EQ(all.scene.furniture.size(), 12U);
    EXPECT_EQ(*place_of(all.scene, all.objects.back()), (Vec3{7.0, 6.0, 0.0}));
    EXPECT_EQ(all.scene.materials, desk.scene.materials);
    expect_sound(all.scene);
}

TEST(AnArray, is_bounded_whatever_is_asked_for) {
    const Added desk = with_furniture(hall(), {"stool", {}}, {1.0, 1.0, 0.0});
    EXPECT_EQ(arrayed(desk.scene, std::array{desk.object}, {100000, 100000, {}, {}}).objects.size(),
              static_cast<std::size_t>(most_copies));
    EXPECT_EQ(arrayed(desk.scene, std::array{desk.object}, {-3, 0, {}, {}}).objects.size(), 1U);
    EXPECT_TRUE(arrayed(desk.scene, {}, {}).objects.empty());
}

TEST(ACircle, turns_chairs_towards_its_middle) {
    const Added chair = with_furniture(hall(), {"chair", {}}, {6.0, 5.5, 0.0});
    const AddedSeveral all = circled(chair.scene, std::array{chair.object}, {4, {6.0, 4.0}});
    ASSERT_EQ(all.objects.size(), 4U);
    EXPECT_LT(glm::distance(*place_of(all.scene, all.objects[1]), (Vec3{4.5, 4.0, 0.0})), rounding);
    EXPECT_NEAR(all.scene.furniture[1].rotation, 0.5 * std::numbers::pi, 1e-12);
    EXPECT_LT(glm::distance(*place_of(all.scene, all.objects[2]), (Vec3{6.0, 2.5, 0.0})), rounding);
    expect_sound(all.scene);
    CircleWish upright{4, {6.0, 4.0}};
    upright.turns = false;
    for (const Furniture& each : circled(chair.scene, std::array{chair.object}, upright).scene.furniture)
        EXPECT_EQ(each.rotation, 0.0);
}

TEST(AMirrorImage, twice_is_the_thing_itself_and_always_sound) {
    std::mt19937 random(5);
    std::uniform_real_distribution<double> angle(-3.0, 3.0);
    for (const FurnitureKind& kind : furniture_library()) {
        if (kind.kind == "pallet-rack" || kind.kind == "box") continue;  // higher than the hall
        const Added added = with_furniture(hall(), {std::string(kind.kind), {}}, {6.0, 4.0, 0.0}, angle(random));
        for (const MirrorAxis axis : {MirrorAxis::x, MirrorAxis::y}) {
            const Scene once = mirrored(added.scene, std::array{added.object}, axis, 5.0);
            expect_sound(once);
            const int k = axis == MirrorAxis::x ? 0 : 1;
            EXPECT_NEAR(bounds(once, added.object).low[k], 10.0 - bounds(added.scene, added.object).high[k], rounding);
            const Scene twice = mirrored(once, std::array{added.object}, axis, 5.0);
            const Bounds before = bounds(added.scene, added.object), after = bounds(twice, added.object);
            EXPECT_LT(glm::distance(before.low, after.low) + glm::distance(before.high, after.high), rounding)
                << kind.kind;
        }
    }
}

TEST(AMirrorImage, of_what_looks_the_same_from_both_sides_keeps_its_model) {
    for (const auto& [kind, keeps] : {std::pair{"desk", true}, std::pair{"round-table", true},
                                      std::pair{"desk-drawers", false}, std::pair{"bookcase", false}}) {
        const Added added = with_furniture(hall(), {kind, {}}, {6.0, 4.0, 0.0}, 0.3);
        const Scene scene = mirrored(added.scene, std::array{added.object}, MirrorAxis::x, 6.0);
        EXPECT_EQ(!scene.furniture[0].model.kind.empty(), keeps) << kind;
        EXPECT_EQ(keeps, follows_model(scene.furniture[0])) << kind;
        EXPECT_NEAR(scene.furniture[0].rotation, -0.3, 1e-12);
    }
}

TEST(AMirrorImage, of_grids_panels_and_points_is_lit_from_the_same_side) {
    Scene scene = with_calculation_point(with_grid(with_panel_luminaire(hall()).scene).scene).scene;
    const ObjectIds all = all_objects(scene);
    const Scene image = mirrored(scene, all, MirrorAxis::y, 4.0);
    expect_sound(image);
    EXPECT_GT(glm::cross(image.grids[0].along, image.grids[0].across).z, 0.0);
}

TEST(AMirroredCopy, leaves_the_original_and_lies_beyond_the_middle_line) {
    const Added desk = with_furniture(hall(), {"desk-drawers", {}}, {2.0, 2.0, 0.0});
    const AddedSeveral image = with_mirror_image(desk.scene, std::array{desk.object}, MirrorAxis::x, 6.0);
    ASSERT_EQ(image.objects.size(), 1U);
    EXPECT_EQ(image.scene.furniture[0], desk.scene.furniture[0]);
    EXPECT_EQ(place_of(image.scene, image.objects[0])->x, 10.0);
    expect_sound(image.scene);
}

/// Three stools and a desk at odd places.
struct Some {
    Scene scene = hall();
    ObjectIds ids;
    Some() {
        for (const auto& [kind, place] :
             {std::pair{"stool", Vec3{1.0, 1.0, 0.0}}, std::pair{"stool", Vec3{3.1, 2.3, 0.0}},
              std::pair{"stool", Vec3{9.0, 4.4, 0.0}}, std::pair{"desk", Vec3{6.0, 6.0, 0.0}}}) {
            Added added = with_furniture(std::move(scene), {kind, {}}, place);
            scene = std::move(added.scene);
            ids.push_back(added.object);
        }
    }
};

TEST(Aligning, brings_every_side_in_line_with_the_one_chosen_last) {
    const Some some;
    const Bounds last = bounds(some.scene, some.ids.back());
    const Scene left = aligned(some.scene, some.ids, Alignment::left);
    const Scene top = aligned(some.scene, some.ids, Alignment::top);
    const Scene middle = aligned(some.scene, some.ids, Alignment::middle_y);
    for (const ObjectId id : some.ids) {
        EXPECT_NEAR(bounds(left, id).low.x, last.low.x, rounding);
        EXPECT_NEAR(bounds(top, id).high.y, last.high.y, rounding);
        EXPECT_NEAR(bounds(middle, id).low.y + bounds(middle, id).high.y, 12.0, rounding);
        EXPECT_EQ(place_of(left, id)->y, place_of(some.scene, id)->y);
    }
    EXPECT_EQ(aligned(some.scene, std::array{some.ids[0]}, Alignment::left), some.scene);
}

TEST(Distributing, makes_gaps_equal_and_leaves_the_outermost) {
    const Some some;
    const Scene scene = distributed(some.scene, some.ids, Spread::x);
    EXPECT_EQ(*place_of(scene, some.ids[0]), *place_of(some.scene, some.ids[0]));
    EXPECT_EQ(*place_of(scene, some.ids[2]), *place_of(some.scene, some.ids[2]));
    const auto gap = [&](std::size_t a, std::size_t b) {
        return bounds(scene, some.ids[b]).low.x - bounds(scene, some.ids[a]).high.x;
    };
    EXPECT_NEAR(gap(0, 1), gap(1, 3), rounding);
    EXPECT_NEAR(gap(1, 3), gap(3, 2), rounding);
}

TEST(AGroup, is_made_of_objects_that_leave_their_groups_and_taken_apart_again) {
    const Some some;
    const Added first = grouped(some.scene, std::array{some.ids[0], some.ids[1]});
    ASSERT_TRUE(first.object);
    EXPECT_EQ(kind_of(first.scene, first.object), ObjectKind::object_group);
    EXPECT_FALSE(can_group(first.scene, std::array{first.object}));
    const Added second = grouped(first.scene, std::array{some.ids[1], some.ids[2]});
    EXPECT_EQ(second.scene.object_groups.size(), 2U);
    EXPECT_EQ(second.scene.object_groups[0].members.size(), 1U);
    const Added all = grouped(second.scene, some.ids);
    EXPECT_EQ(all.scene.object_groups.size(), 1U);
    expect_sound(all.scene);
    const Ungrouped apart = ungrouped(all.scene, std::array{all.object});
    EXPECT_TRUE(apart.scene.object_groups.empty());
    EXPECT_EQ(apart.members, some.ids);
    EXPECT_FALSE(can_group(some.scene, std::array{some.ids[0]}));
    EXPECT_FALSE(can_ungroup(some.scene, some.ids));
    EXPECT_FALSE(grouped(some.scene, {}).object);
}

TEST(AGroup, of_what_is_not_there_or_in_two_groups_is_told) {
    Scene scene = Some().scene;
    const ObjectId stool = scene.furniture[0].id;
    scene.object_groups.push_back({scene.new_id(), "A", {stool, ObjectId{999}}, {}});
    scene.object_groups.push_back({scene.new_id(), "B", {stool}, {}});
    scene.object_groups.push_back({scene.new_id(), "C", {}, {}});
    const Diagnostics findings = check_scene(scene);
    ASSERT_EQ(findings.size(), 3U);
    EXPECT_EQ(findings[0].place.field, "object_groups[0].members[1]");
    EXPECT_EQ(findings[1].place.field, "object_groups[1].members[0]");
    EXPECT_EQ(findings[2].severity, Severity::warning);
}

TEST(Furniture, pushed_against_the_wall_touches_it_and_looks_into_the_room) {
    for (const auto& [place, wall] : {std::pair{Vec3{6.0, 1.1, 0.0}, 0}, std::pair{Vec3{11.0, 4.0, 0.0}, 1},
                                      std::pair{Vec3{6.0, 7.0, 0.0}, 2}, std::pair{Vec3{0.9, 4.0, 0.0}, 3}}) {
        const Added shelf = with_furniture(hall(), {"bookcase", {}}, place, 1.0);
        const auto pushed = against_wall(shelf.scene, shelf.object, 5.0);
        ASSERT_TRUE(pushed);
        expect_sound(*pushed);
        const RoomFace face = *room_face(*pushed->room, Room::wall_face(wall));
        const Bounds box = bounds(*pushed, shelf.object);
        const double nearest =
            std::min(glm::dot(box.low - face.origin, face.inward), glm::dot(box.high - face.origin, face.inward));
        EXPECT_NEAR(nearest, 0.0, rounding) << wall;
        const double turn = pushed->furniture[0].rotation;
        const Vec3 front{std::sin(turn), -std::cos(turn), 0.0};
        EXPECT_NEAR(glm::dot(front, face.inward), 1.0, 1e-12) << wall;
    }
    const Added far = with_furniture(hall(), {"bookcase", {}}, {6.0, 4.0, 0.0});
    EXPECT_FALSE(against_wall(far.scene, far.object, 0.3));
    EXPECT_FALSE(against_wall({}, far.object, 9.0));
}

TEST(Furniture, put_on_the_floor_stands_on_it) {
    Scene scene = hall();
    scene.room->floor_height = -0.4;
    const Added computer = with_furniture(scene, {"computer", {}}, {6.0, 4.0, 0.7});
    EXPECT_NEAR(bounds(on_floor(computer.scene, std::array{computer.object}), computer.object).low.z, -0.4, rounding);
}

TEST(Furniture, stands_clear_or_not) {
    const Added desk = with_furniture(hall(), {"desk", {}}, {6.0, 4.0, 0.0});
    const auto clear = [&](const Vec3& place, const char* kind) {
        const Added other = with_furniture(desk.scene, {kind, {}}, place);
        return stands_clear(other.scene, other.object);
    };
    EXPECT_TRUE(clear({8.0, 4.0, 0.0}, "desk"));
    EXPECT_TRUE(clear({6.0, 4.0, 0.74}, "computer"));
    EXPECT_TRUE(clear({6.0, 4.0, 0.0}, "stool"));  // below the top, between the legs
    EXPECT_FALSE(clear({6.5, 4.0, 0.0}, "desk"));
    EXPECT_FALSE(clear({0.2, 4.0, 0.0}, "desk"));
}

TEST(ASubArea, is_moved_copied_and_deleted_as_other_objects_are) {
    const Added door = with_sub_area(hall(), *find_sub_area_kind("door"), Room::wall_face(0));
    const double x = place_of(door.scene, door.object)->x;
    const Scene scene = moved(door.scene, door.object, {1.5, 3.0, 0.0});
    EXPECT_NEAR(place_of(scene, door.object)->x, x + 1.5, rounding);
    EXPECT_EQ(place_of(scene, door.object)->y, 0.0);
    const AddedSeveral copy = duplicated(scene, std::array{door.object});
    ASSERT_EQ(copy.objects.size(), 1U);
    EXPECT_EQ(kind_of(copy.scene, copy.objects[0]), ObjectKind::sub_area);
    expect_sound(copy.scene);
    EXPECT_TRUE(removed(copy.scene, copy.scene.room->sub_areas[1].id).room->sub_areas.size() == 1);
    EXPECT_EQ(display_name(copy.scene, copy.objects[0]), "Door 2");
    EXPECT_EQ(object_named(copy.scene, "Door 2"), copy.objects[0]);
}

TEST(ASubArea, is_copied_to_another_room_with_its_material) {
    const Added door = with_sub_area(hall(), *find_sub_area_kind("door"), Room::wall_face(1));
    const Scene alone = excerpt(door.scene, std::array{door.object});
    expect_sound(alone);
    ASSERT_TRUE(alone.room);
    EXPECT_EQ(alone.room->sub_areas.size(), 1U);
    const AddedSeveral pasted = with_excerpt(empty_room(), alone, Vec3{0.0});
    ASSERT_EQ(pasted.objects.size(), 1U);
    expect_sound(pasted.scene);
    const SubArea& copy = pasted.scene.room->sub_areas.front();
    EXPECT_EQ(copy.face, Room::wall_face(1));
    EXPECT_EQ(copy.low.y, 0.0);
    EXPECT_EQ(display_name(pasted.scene, copy.material), "Door");
    EXPECT_EQ(pasted.scene.furniture.size(), empty_room().furniture.size());
    const AddedSeveral elsewhere =
        with_excerpt(empty_room(), alone, Vec3{0.0}, FacePlace{Room::wall_face(2), {2.0, 1.0}, 0.0});
    const SubArea& there = elsewhere.scene.room->sub_areas.front();
    EXPECT_EQ(there.face, Room::wall_face(2));
    EXPECT_NEAR(0.5 * (there.low.x + there.high.x), 2.0, rounding);
    EXPECT_EQ(there.low.y, 0.0) << "doors stay on the floor";
    Scene no_room = empty_room();
    no_room.room.reset();
    EXPECT_TRUE(with_excerpt(no_room, alone, Vec3{0.0}).objects.empty());
}

}  // namespace
}  // namespace hanei
