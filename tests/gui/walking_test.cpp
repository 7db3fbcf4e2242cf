#include "computer_room.h"
#include "engine/edit/plan_shape.h"
#include "ui/panels/state_text.h"

#include <cmath>

namespace hanei {
namespace {

std::string state(const Driver& driver, const std::string& name) { return state_of(driver.workbench())[name]; }
const Camera& camera(const Driver& driver) { return driver.workbench().viewport().state.camera; }
bool is_in_room(const Driver& driver) {
    return plan_holds(driver.workbench().document().shown()->room->plan, Vec2(camera(driver).eye));
}

#define EXPECT_DONE(action) EXPECT_EQ(action, "")

TEST(Walk, a_key_takes_the_eye_into_the_room_at_a_standing_persons_height) {
    Driver driver(computer_room());
    EXPECT_FALSE(is_in_room(driver));
    EXPECT_DONE(driver.press("W"));
    EXPECT_EQ(state(driver, "walking"), "true");
    EXPECT_TRUE(is_in_room(driver));
    EXPECT_EQ(camera(driver).eye.z, 1.6);
    EXPECT_NEAR(camera(driver).target.z, 1.6, 1e-9) << "looking level";
    EXPECT_NE(driver.workbench().widgets().find("walk.readout"), nullptr);
    EXPECT_DONE(driver.press("Esc"));
    EXPECT_EQ(state(driver, "walking"), "false");
    EXPECT_TRUE(is_in_room(driver)) << "and stays there";
}

TEST(Walk, a_second_of_walking_is_a_persons_pace_and_shift_a_hurry) {
    Driver driver(computer_room());
    EXPECT_DONE(driver.press("W"));
    const auto gone = [&](std::string_view chord) {
        const Vec3 before = camera(driver).eye;
        EXPECT_DONE(driver.press(chord, 0.5));
        return glm::distance(camera(driver).eye, before);
    };
    EXPECT_NEAR(gone("W"), 0.7, 0.03);  // m: a frame more or less
    EXPECT_NEAR(gone("S"), 0.7, 0.03);
    EXPECT_NEAR(gone("Up"), 0.7, 0.03);
    EXPECT_NEAR(gone("Shift+Up"), 1.75, 0.1);
    EXPECT_EQ(state(driver, "undo depth"), "0") << "walking changes nothing of the room";
}

TEST(Walk, arrows_turn_and_letters_step_aside) {
    Driver driver(computer_room());
    EXPECT_DONE(driver.press("W"));
    const Vec3 forward = axes_of(camera(driver)).forward, right = axes_of(camera(driver)).right;
    const Vec3 before = camera(driver).eye;
    EXPECT_DONE(driver.press("D", 0.3));
    EXPECT_GT(glm::dot(camera(driver).eye - before, right), 0.2);
    EXPECT_NEAR(glm::dot(camera(driver).eye - before, forward), 0.0, 1e-6);
    EXPECT_DONE(driver.press("Left", 0.5));
    EXPECT_NEAR(glm::dot(axes_of(camera(driver)).forward, forward), std::cos(0.65), 0.03);
    EXPECT_LT(glm::dot(axes_of(camera(driver)).forward, right), 0.0);
}

TEST(Walk, who_walks_on_is_held_by_the_wall_and_told_so) {
    Driver driver(computer_room());
    EXPECT_DONE(driver.press("W"));
    const ScreenRect free = *driver.workbench().widgets().find("walk.readout");
    EXPECT_DONE(driver.press("Shift+W", 3.0));
    EXPECT_TRUE(is_in_room(driver));
    const Vec3 before = camera(driver).eye;
    EXPECT_DONE(driver.press("W", 0.5));
    EXPECT_LT(glm::distance(camera(driver).eye, before), 0.35) << "it slides at most";
    EXPECT_TRUE(is_in_room(driver));
    EXPECT_DONE(driver.press("Shift+W", 3.0));  // by now into a corner
    const ScreenRect held = *driver.workbench().widgets().find("walk.readout");
    EXPECT_GT(held.right - held.left, free.right - free.left + 20.0F) << "the wall is named";
}

TEST(Walk, the_eye_is_raised_and_lowered_within_the_room) {
    Driver driver(computer_room());
    EXPECT_DONE(driver.press("W"));
    EXPECT_DONE(driver.press("Q", 0.5));
    EXPECT_NEAR(camera(driver).eye.z, 1.2, 0.03);
    EXPECT_DONE(driver.press("Page Down", 1.5));
    EXPECT_NEAR(camera(driver).eye.z, 0.3, 1e-9);
    EXPECT_DONE(driver.press("E", 4.0));
    const Room& room = *driver.workbench().document().shown()->room;
    EXPECT_NEAR(camera(driver).eye.z, room.floor_height + room.height - 0.1, 1e-9);
}

TEST(Walk, a_drag_looks_around_and_a_right_click_ends_it) {
    Driver driver(computer_room());
    EXPECT_DONE(driver.press("W"));
    const Camera before = camera(driver);
    driver.drag_over({500.0F, 400.0F}, {560.0F, 340.0F});
    EXPECT_EQ(camera(driver).eye, before.eye) << "only the gaze turns";
    EXPECT_GT(glm::dot(axes_of(camera(driver)).forward, axes_of(before).right), 0.15);
    EXPECT_GT(axes_of(camera(driver)).forward.z, 0.15);
    driver.drag_over({500.0F, 200.0F}, {500.0F, 700.0F});
    driver.drag_over({500.0F, 200.0F}, {500.0F, 700.0F});
    EXPECT_GT(axes_of(camera(driver)).up.z, 0.1) << "never head over heels";
    driver.point_at(500.0F, 300.0F);
    driver.button(1, true);
    driver.button(1, false);
    EXPECT_EQ(state(driver, "walking"), "false");
    EXPECT_EQ(driver.workbench().chosen(), ObjectId{});
}

TEST(Walk, a_view_is_kept_where_one_stands_and_walked_on_from_when_recalled) {
    Driver driver(computer_room());
    EXPECT_DONE(driver.press("W"));
    EXPECT_DONE(driver.press("W", 0.5));
    const Camera kept = camera(driver);
    EXPECT_DONE(driver.press("Ctrl+K"));
    EXPECT_DONE(driver.press("S", 0.5));
    const std::size_t number = driver.workbench().document().shown()->views.size();
    EXPECT_DONE(driver.press("Ctrl+" + std::to_string(number)));
    EXPECT_TRUE(camera(driver) == kept);
    EXPECT_EQ(state(driver, "walking"), "true");
    EXPECT_DONE(driver.press("W", 0.2));
    EXPECT_NEAR(glm::distance(camera(driver).eye, kept.eye), 0.28, 0.03);
}

TEST(Walk, a_plan_ends_the_walk_and_the_button_begins_it_again) {
    Driver driver(computer_room());
    EXPECT_DONE(driver.click("bar.view.walk"));
    EXPECT_EQ(state(driver, "walking"), "true");
    EXPECT_DONE(driver.press("P"));
    EXPECT_EQ(state(driver, "walking"), "false");
    EXPECT_DONE(driver.click("menu.View"));
    EXPECT_DONE(driver.click("view.walk"));
    EXPECT_EQ(state(driver, "walking"), "true");
    EXPECT_DONE(driver.click("bar.view.walk"));
    EXPECT_EQ(state(driver, "walking"), "false");
}

TEST(Walk, letters_typed_into_a_field_do_not_walk) {
    Driver driver(computer_room());
    EXPECT_DONE(driver.click("tree.Cooler"));
    EXPECT_DONE(driver.press("W"));
    const Vec3 before = camera(driver).eye;
    EXPECT_DONE(driver.press("F3"));
    driver.type("w");
    EXPECT_DONE(driver.press("W", 0.5));
    EXPECT_EQ(camera(driver).eye, before);
    EXPECT_DONE(driver.press("Esc"));
    EXPECT_EQ(state(driver, "walking"), "true") << "only the list was closed";
}

TEST(ViewMenu, fits_a_small_window_and_reaches_what_stands_in_menus_within_it) {
    Driver::Setup small = computer_room();
    small.size = {800, 600};
    Driver driver(std::move(small));
    EXPECT_DONE(driver.click("menu.View"));
    const auto* const last = driver.workbench().widgets().find("menu.View.Letters and colours");
    ASSERT_NE(last, nullptr);
    EXPECT_LT(last->bottom, 600.0F);
    EXPECT_EQ(driver.workbench().widgets().find("view.front"), nullptr);
    EXPECT_DONE(driver.click("menu.View.Look from"));
    EXPECT_DONE(driver.click("view.front"));
    EXPECT_EQ(standpoint_of(camera(driver)), Standpoint::front);
}

}  // namespace
}  // namespace hanei
