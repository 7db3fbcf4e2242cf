#include "app/desktop.h"
#include "engine/edit/furniture_edits.h"
#include "engine/edit/plan_edits.h"
#include "engine/edit/several.h"
#include "engine/edit/sub_areas.h"
#include "ui/panels/state_text.h"
#include "ui/window/driver.h"

#include <gtest/gtest.h>

namespace hanei {
namespace {

#define EXPECT_DONE(action) EXPECT_EQ(action, "")

/// A dark room with wide patches: the window is on trial here, not the light.
Driver::Setup empty_setup() {
    ProjectContent content{empty_room(), {}};
    content.settings.max_patch = 2.0;
    return {content, {}, project_door()};
}

const Scene& scene_of(const Driver& driver) { return *driver.workbench().document().shown(); }
std::size_t depth(const Driver& driver) { return std::stoul(state_of(driver.workbench())["undo depth"]); }

void click_at(Driver& driver, const Vec3& place) {
    const auto at = driver.workbench().viewport().on_screen(place);
    ASSERT_TRUE(at);
    driver.point_at(at->x, at->y);
    driver.frames(2);
    driver.button(0, true);
    driver.frames(2);
    driver.button(0, false);
    driver.frames(20);  // far enough apart to be no double click
}

TEST(Furnishing, begins_a_new_room_of_the_sizes_asked_for) {
    Driver driver(empty_setup());
    driver.frames(3);
    EXPECT_DONE(driver.press("Ctrl+Shift+N"));
    EXPECT_DONE(driver.click("new.length"));
    driver.type("8.5");
    EXPECT_DONE(driver.press("Enter"));
    EXPECT_DONE(driver.click("new.shape"));
    EXPECT_DONE(driver.click("new.shape.L"));
    EXPECT_DONE(driver.click("new.ok"));
    constexpr double inner = 0.4 * 8.5;
    EXPECT_EQ(scene_of(driver).room->plan,
              (std::vector<Vec2>{{0.0, 0.0}, {8.5, 0.0}, {8.5, 1.6}, {inner, 1.6}, {inner, 4.0}, {0.0, 4.0}}));
    EXPECT_EQ(depth(driver), 0U);
    EXPECT_DONE(driver.press("Ctrl+Shift+N"));
    EXPECT_DONE(driver.press("Esc"));
    EXPECT_FALSE(driver.workbench().furnishing().is_asking());
}

TEST(Furnishing, adds_pieces_by_click_and_by_drag_from_the_library) {
    Driver driver(empty_setup());
    driver.frames(3);
    EXPECT_DONE(driver.click("tab.Furniture"));
    EXPECT_DONE(driver.click("library.desk"));
    ASSERT_EQ(scene_of(driver).furniture.size(), 1U);
    EXPECT_EQ(driver.workbench().chosen(), scene_of(driver).furniture[0].id);
    EXPECT_DONE(driver.drag("library.round-table", 400.0F, 60.0F));
    ASSERT_EQ(scene_of(driver).furniture.size(), 2U);
    EXPECT_EQ(scene_of(driver).furniture[1].model.kind, "round-table");
    EXPECT_EQ(driver.workbench().viewport().tool(), nullptr);
    EXPECT_EQ(depth(driver), 2U);
    for (int k = 0; k < 2; ++k) EXPECT_DONE(driver.press("Ctrl+Z"));
    EXPECT_EQ(scene_of(driver), empty_room());
}

TEST(Furnishing, sizes_of_a_piece_change_its_parts) {
    Driver driver(empty_setup());
    driver.frames(3);
    EXPECT_DONE(driver.click("tab.Furniture"));
    EXPECT_DONE(driver.click("library.desk"));
    EXPECT_DONE(driver.click("tab.Properties"));
    EXPECT_DONE(driver.click("model.width"));
    driver.type("2.2");
    EXPECT_DONE(driver.press("Enter"));
    EXPECT_EQ(own_bounds(scene_of(driver).furniture[0]).high.x, 1.1);
    EXPECT_TRUE(follows_model(scene_of(driver).furniture[0]));
}

TEST(Furnishing, draws_a_plan_by_clicks_and_typed_lengths_and_refuses_crossing_walls) {
    Driver driver(empty_setup());
    driver.frames(3);
    EXPECT_DONE(driver.click("menu.Room"));
    EXPECT_DONE(driver.click("room.draw"));
    driver.frames(3);
    click_at(driver, {1.0, 1.0, 0.0});
    click_at(driver, {4.0, 1.0, 0.0});
    const auto up = driver.workbench().viewport().on_screen({4.0, 2.0, 0.0});
    ASSERT_TRUE(up);
    driver.point_at(up->x, up->y);
    driver.frames(2);
    driver.type("2.35");
    EXPECT_DONE(driver.press("Enter"));
    click_at(driver, {2.0, 0.5, 0.0});  // would cross the first wall
    click_at(driver, {1.0, 3.0, 0.0});
    EXPECT_DONE(driver.press("Enter"));
    EXPECT_EQ(scene_of(driver).room->plan, (std::vector<Vec2>{{1.0, 1.0}, {4.0, 1.0}, {4.0, 3.35}, {1.0, 3.0}}));
    EXPECT_EQ(depth(driver), 1U);
    EXPECT_EQ(driver.workbench().chosen(), scene_of(driver).room->id);
    EXPECT_DONE(driver.drag("room.handle.corner1", -40.0F, 40.0F));
    EXPECT_LT(scene_of(driver).room->plan[0].x, 1.0);
    EXPECT_LT(scene_of(driver).room->plan[0].y, 1.0);
    EXPECT_EQ(depth(driver), 2U);
    EXPECT_DONE(driver.drag("room.handle.wall2", 40.0F, 0.0F));
    EXPECT_GT(scene_of(driver).room->plan[1].x, 4.0);
    EXPECT_EQ(depth(driver), 3U);
}

TEST(Furnishing, puts_a_door_and_a_window_into_walls_and_drags_them_along) {
    Driver driver(empty_setup());
    driver.frames(3);
    EXPECT_DONE(driver.click("tree.Room"));
    EXPECT_DONE(driver.click("room.add.door"));
    ASSERT_EQ(scene_of(driver).room->sub_areas.size(), 1U);
    const ObjectId door = scene_of(driver).room->sub_areas[0].id;
    EXPECT_EQ(driver.workbench().chosen(), door);
    EXPECT_DONE(driver.click("area.x"));
    driver.type("0.5");
    EXPECT_DONE(driver.press("Enter"));
    EXPECT_EQ(scene_of(driver).room->sub_areas[0].low.x, 0.5);
    EXPECT_DONE(driver.press("Ctrl+D"));
    EXPECT_EQ(scene_of(driver).room->sub_areas.size(), 2U);
    EXPECT_DONE(driver.press("Delete"));
    EXPECT_EQ(scene_of(driver).room->sub_areas.size(), 1U);
    EXPECT_DONE(driver.click("tree.Room"));
    EXPECT_DONE(driver.click("room.preset.80/50/30"));
    EXPECT_EQ(reflectances_of(scene_of(driver)), (Reflectances{0.8, 0.5, 0.3}));
}

TEST(Furnishing, makes_an_array_with_a_preview_that_is_one_step_or_none) {
    Driver driver(empty_setup());
    driver.frames(3);
    EXPECT_DONE(driver.click("tab.Furniture"));
    EXPECT_DONE(driver.click("library.desk"));
    EXPECT_EQ(scene_of(driver).furniture.size(), 1U);
    EXPECT_DONE(driver.click("menu.Arrange"));
    EXPECT_DONE(driver.click("arrange.array"));
    driver.frames(2);
    EXPECT_EQ(scene_of(driver).furniture.size(), 3U);  // a preview
    EXPECT_EQ(depth(driver), 1U);
    EXPECT_DONE(driver.click("copies.cancel"));
    EXPECT_EQ(scene_of(driver).furniture.size(), 1U);
    EXPECT_DONE(driver.press("Ctrl+Shift+D"));
    EXPECT_DONE(driver.click("array.rows"));
    driver.type("2");
    EXPECT_DONE(driver.press("Enter"));
    EXPECT_DONE(driver.click("copies.ok"));
    EXPECT_EQ(scene_of(driver).furniture.size(), 6U);
    EXPECT_EQ(depth(driver), 2U);
    EXPECT_EQ(driver.workbench().selection().ids().size(), 6U);
    EXPECT_DONE(driver.press("Ctrl+G"));
    EXPECT_EQ(scene_of(driver).object_groups.size(), 1U);
    EXPECT_DONE(driver.press("Ctrl+Shift+G"));
    EXPECT_TRUE(scene_of(driver).object_groups.empty());
}

}  // namespace
}  // namespace hanei
