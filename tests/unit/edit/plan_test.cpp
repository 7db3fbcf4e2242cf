#include "engine/edit/plan_edits.h"
#include "engine/edit/plan_shape.h"
#include "engine/edit/sub_areas.h"
#include "engine/geometry/polygon.h"
#include "engine/scene/faces.h"
#include "engine/scene/scene_check.h"

#include <gtest/gtest.h>

namespace hanei {
namespace {

void expect_sound(const Scene& scene) {
    for (const Diagnostic& finding : check_scene(scene))
        EXPECT_EQ(finding.severity, Severity::note) << to_text(finding);
}

/// A box room with a window in wall 2 (x = 6, y from 0 to 4) at 1.25 to 2.75.
Scene room_with_window() {
    return with_sub_area(empty_room(), *find_sub_area_kind("window"), Room::wall_face(1)).scene;
}

Vec3 window_place(const Scene& scene) { return *place_of_sub_area(scene, scene.room->sub_areas.front().id); }

TEST(ANewRoom, of_every_shape_is_sound_and_as_large_as_wished) {
    for (const char* shape : {"box", "L", "T", "U"}) {
        NewRoom wished;
        wished.shape = shape;
        wished.length = 9.0;
        wished.width = 7.0;
        wished.height = 3.2;
        wished.reflectances = {0.8, 0.3, 0.25};
        const Scene scene = new_room(wished);
        expect_sound(scene);
        const Bounds bounds = bounds_of(scene);
        EXPECT_EQ(bounds.low, (Vec3{0.0, 0.0, 0.0})) << shape;
        EXPECT_EQ(bounds.high, (Vec3{9.0, 7.0, 3.2})) << shape;
        EXPECT_EQ(reflectances_of(scene)->ceiling, 0.8);
        EXPECT_NEAR(reflectances_of(scene)->walls, 0.3, 1e-12);  // a mean over walls of one material
    }
}

TEST(ADrawnPlan, may_run_either_way_and_have_corners_on_straight_walls) {
    const std::vector<Vec2> clockwise{{0.0, 0.0}, {0.0, 3.0}, {5.0, 3.0}, {5.0, 1.0}, {5.0, 0.0}};
    const PlanEdit drawn = with_plan(empty_room(), clockwise);
    ASSERT_TRUE(drawn.scene);
    EXPECT_EQ(drawn.scene->room->plan.size(), 4U);
    EXPECT_GT(signed_area(drawn.scene->room->plan), 0.0);
    expect_sound(*drawn.scene);
}

TEST(ADrawnPlan, makes_a_room_with_materials_where_there_was_none) {
    Scene none;
    none.materials.push_back({none.new_id(), "Wood", 0.4, {}});
    none.new_id();
    const PlanEdit drawn = with_plan(none, {{0.0, 0.0}, {5.0, 0.0}, {5.0, 3.0}, {2.0, 4.0}, {0.0, 3.0}});
    ASSERT_TRUE(drawn.scene);
    expect_sound(*drawn.scene);
    EXPECT_EQ(reflectances_of(*drawn.scene)->ceiling, 0.7);
    EXPECT_EQ(reflectances_of(*drawn.scene)->floor, 0.2);
}

TEST(ADrawnPlan, that_meets_itself_is_refused_with_one_sentence) {
    const PlanEdit bow = with_plan(empty_room(), {{0.0, 0.0}, {4.0, 4.0}, {4.0, 0.0}, {0.0, 4.0}});
    EXPECT_FALSE(bow.scene);
    EXPECT_EQ(bow.message, "Walls cross or touch each other; draw an outline that does not meet itself.");
    EXPECT_FALSE(with_plan(empty_room(), {{0.0, 0.0}, {4.0, 0.0}}).scene);
    EXPECT_FALSE(with_plan(empty_room(), {{0.0, 0.0}, {4.0, 0.0}, {2.0, 0.0}}).scene);
    EXPECT_FALSE(with_plan(empty_room(), {{0.0, 0.0}, {std::nan(""), 0.0}, {2.0, 3.0}}).scene);
    EXPECT_FALSE(with_plan(empty_room(), {}).scene);
}

TEST(ADrawnLine, is_told_when_its_last_edge_crosses_another) {
    const std::vector<Vec2> bent{{0.0, 0.0}, {4.0, 0.0}, {4.0, 3.0}};
    const auto with = [&](Vec2 next) {
        std::vector<Vec2> line = bent;
        line.push_back(next);
        return last_edge_crosses(line);
    };
    EXPECT_TRUE(with({2.0, -1.0}));
    EXPECT_TRUE(with({4.0, 1.0}));  // back along the wall before
    EXPECT_FALSE(with({0.0, 3.0}));
    EXPECT_FALSE(with({4.0, 5.0}));
}

TEST(APlanInWords, is_pairs_of_figures) {
    EXPECT_EQ(plan_of_text("0,0 6,0 6,4.5 0,4").size(), 4U);
    EXPECT_EQ(plan_of_text("0,0 6,0 6,4.5")[2], (Vec2{6.0, 4.5}));
    EXPECT_TRUE(plan_of_text("0,0 6;0").empty());
    EXPECT_TRUE(plan_of_text("0,0 6,0x").empty());
    EXPECT_TRUE(plan_of_text("").empty());
}

TEST(AWindow, stays_where_it_is_when_a_corner_of_its_wall_moves_along_the_wall) {
    const Scene before = room_with_window();
    const Vec3 place = window_place(before);
    for (const std::size_t corner : {1U, 2U}) {
        const Vec2 to = before.room->plan[corner] + Vec2{0.0, corner == 1 ? -1.0 : 1.0};
        const PlanEdit edit = with_corner_moved(before, corner, to);
        ASSERT_TRUE(edit.scene);
        EXPECT_LT(glm::distance(window_place(*edit.scene), place), 1e-9);  // coordinates are kept to the nanometre
        expect_sound(*edit.scene);
    }
}

TEST(AWindow, follows_its_wall_and_shrinks_with_it) {
    const Scene before = room_with_window();
    const PlanEdit out = with_wall_moved(before, 1, 2.0);
    ASSERT_TRUE(out.scene);
    EXPECT_EQ(out.scene->room->plan[1], (Vec2{8.0, 0.0}));
    EXPECT_EQ(window_place(*out.scene).x, 8.0);
    EXPECT_EQ(out.scene->room->sub_areas, before.room->sub_areas);
    const PlanEdit narrow = with_wall_length(before, 1, 1.0);
    ASSERT_TRUE(narrow.scene);
    EXPECT_EQ(narrow.scene->room->plan, (std::vector<Vec2>{{0.0, 0.0}, {6.0, 0.0}, {6.0, 1.0}, {0.0, 1.0}}));
    EXPECT_EQ(narrow.scene->room->sub_areas[0].low.x, 0.0);
    EXPECT_EQ(narrow.scene->room->sub_areas[0].high.x, 1.0);
    expect_sound(*narrow.scene);
}

TEST(AWindow, goes_with_its_wall_and_is_said_to) {
    const PlanEdit edit = with_corner_removed(room_with_window(), 2);
    ASSERT_TRUE(edit.scene);
    EXPECT_EQ(edit.scene->room->sub_areas.size(), 1U);  // its wall is the one from corner 2, turned
    const PlanEdit gone = with_corner_removed(room_with_window(), 1);
    ASSERT_TRUE(gone.scene);
    EXPECT_TRUE(gone.scene->room->sub_areas.empty());
    EXPECT_EQ(gone.message, "Window went with its wall");
    expect_sound(*gone.scene);
}

TEST(AWindow, stays_on_its_part_of_a_wall_that_is_cut_in_two) {
    const Scene before = room_with_window();
    const Vec3 place = window_place(before);
    for (const double y : {1.0, 3.0}) {
        const PlanEdit edit = with_corner_inserted(before, 1, {6.5, y});
        ASSERT_TRUE(edit.scene);
        EXPECT_EQ(edit.scene->room->wall_materials.size(), 5U);
        EXPECT_LT(glm::distance(window_place(*edit.scene), place), 0.5);  // the wall turned by up to half a metre
        EXPECT_EQ(edit.scene->room->sub_areas[0].face, Room::wall_face(y < 2.0 ? 2 : 1));
        expect_sound(*edit.scene);
    }
}

TEST(AWall, that_would_cross_another_stays) {
    const PlanEdit edit = with_wall_moved(empty_room(), 0, -5.0);
    EXPECT_FALSE(edit.scene);
    EXPECT_FALSE(edit.message.empty());
    EXPECT_FALSE(with_wall_length(empty_room(), 0, 0.0).scene);
    EXPECT_FALSE(with_wall_length(empty_room(), 9, 1.0).scene);
    EXPECT_FALSE(with_corner_moved({}, 0, {}).scene);
}

TEST(AWall, of_an_L_keeps_its_neighbours_upright_when_it_moves) {
    NewRoom wished;
    wished.shape = "L";
    const PlanEdit edit = with_wall_moved(new_room(wished), 2, -0.3);
    ASSERT_TRUE(edit.scene);
    const std::vector<Vec2>& plan = edit.scene->room->plan;
    for (std::size_t k = 0; k < plan.size(); ++k) {
        const Vec2 wall = plan[(k + 1) % plan.size()] - plan[k];
        EXPECT_NEAR(wall.x * wall.y, 0.0, 1e-9);
    }
}

TEST(SubAreas, of_every_kind_lie_within_their_face_clear_of_each_other) {
    Scene scene = empty_room();
    scene.room->plan = usual_plan("box", 14.0, 9.0);
    for (const SubAreaKind& kind : sub_area_kinds()) {
        const int face = kind.level ? Room::floor_face : Room::wall_face(0);
        Added added = with_sub_area(std::move(scene), kind, face);
        EXPECT_TRUE(added.object) << kind.kind;
        EXPECT_EQ(kind_of(added.scene, added.object), ObjectKind::sub_area);
        scene = std::move(added.scene);
    }
    expect_sound(scene);
    EXPECT_TRUE(can_remove(ObjectKind::sub_area));
    const std::size_t count = scene.room->sub_areas.size();
    scene = with_sub_area_copied(std::move(scene), scene.room->sub_areas[2].id).scene;
    EXPECT_EQ(scene.room->sub_areas.size(), count + 1);
    scene = removed(std::move(scene), scene.room->sub_areas.back().id);
    EXPECT_EQ(scene.room->sub_areas.size(), count);
}

TEST(SubAreas, slide_along_their_wall_and_stop_at_its_ends) {
    Scene scene = room_with_window();
    const ObjectId window = scene.room->sub_areas.front().id;
    scene = with_sub_area_moved(std::move(scene), window, {5.0, 0.5, 0.0});
    EXPECT_EQ(place_of_sub_area(scene, window)->y, 2.5);
    EXPECT_EQ(place_of_sub_area(scene, window)->x, 6.0);
    scene = with_sub_area_moved(std::move(scene), window, {0.0, 50.0, 50.0});
    EXPECT_EQ(scene.room->sub_areas[0].high, (Vec2{4.0, 2.8}));
    EXPECT_EQ(scene.room->sub_areas[0].high.x - scene.room->sub_areas[0].low.x, 1.5);
}

TEST(SubAreas, are_cut_to_small_faces_and_refused_by_none) {
    Scene scene = empty_room();
    scene.room->height = 2.0;
    const Added door = with_sub_area(scene, *find_sub_area_kind("door"), Room::wall_face(3), 0.0);
    EXPECT_EQ(door.scene.room->sub_areas[0].high, (Vec2{0.9, 2.0}));
    EXPECT_FALSE(with_sub_area(scene, *find_sub_area_kind("door"), 17).object);
    EXPECT_FALSE(with_sub_area({}, *find_sub_area_kind("door"), 0).object);
}

TEST(TheFaceUnderARay, is_the_nearest_that_looks_at_it) {
    const Scene scene = room_with_window();
    const auto met = face_under(*scene.room, {3.0, 2.0, 1.5}, {1.0, 0.0, 0.0});
    ASSERT_TRUE(met);
    EXPECT_EQ(met->face, Room::wall_face(1));
    EXPECT_NE(sub_area_at(*scene.room, met->face, met->at), nullptr);
    const auto floor = face_under(*scene.room, {3.0, 2.0, 20.0}, {0.0, 0.0, -1.0});
    ASSERT_TRUE(floor);
    EXPECT_EQ(floor->face, Room::floor_face);  // the ceiling's back is looked through
    EXPECT_FALSE(face_under(*scene.room, {30.0, 2.0, 20.0}, {0.0, 0.0, -1.0}));
    EXPECT_NEAR(area_of_face(*scene.room, Room::floor_face), 24.0, 1e-12);
    EXPECT_NEAR(area_of_face(*scene.room, Room::wall_face(0)), 16.8, 1e-12);
}

}  // namespace
}  // namespace hanei
