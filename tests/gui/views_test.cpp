#include "app/desktop.h"
#include "engine/edit/edit.h"
#include "ui/panels/state_text.h"
#include "ui/window/driver.h"

#include <gtest/gtest.h>

namespace hanei {
namespace {

const std::string panel = "Ceiling panel 1";

/// The computer room with wide patches: pictures are on trial here, not figures.
Driver::Setup setup() {
    const auto file = std::filesystem::path(HANEI_SOURCE) / "assets/rooms/computer-room-panels.hanei";
    Opened<ProjectContent> opened = project_door().open(file);
    EXPECT_TRUE(opened.content);
    opened.content->settings.max_patch = 1.5;
    return {*opened.content, std::filesystem::path(testing::TempDir()) / "views.hanei", project_door()};
}

std::string state(const Driver& driver, const std::string& name) { return state_of(driver.workbench())[name]; }
const ViewState& view(const Driver& driver) { return driver.workbench().viewport().state; }
Vec3 place(const Driver& driver, const std::string& name) {
    const Scene& scene = *driver.workbench().document().shown();
    return *place_of(scene, object_named(scene, name));
}

/// The pointer over the middle of a picture.
void point_at_picture(Driver& driver, int k) {
    const Pane& pane = view(driver).panes.pane(k);
    driver.point_at(pane.left + 0.5F * pane.width, pane.top + 0.5F * pane.height);
}

#define EXPECT_DONE(action) EXPECT_EQ(action, "")

TEST(Views, four_pictures_each_turn_and_zoom_by_themselves) {
    Driver driver(setup());
    EXPECT_DONE(driver.press("7"));
    ASSERT_EQ(view(driver).panes.count(), 4);
    const PaneSet before = view(driver).panes;
    const Camera front = before.camera(2, view(driver).camera);
    point_at_picture(driver, 2);
    driver.wheel(3.0F);
    EXPECT_EQ(view(driver).panes.active(), 2);
    EXPECT_FALSE(view(driver).camera == front);
    EXPECT_EQ(standpoint_of(view(driver).camera), Standpoint::front) << "still a drawing";
    for (const int k : {0, 3}) {
        EXPECT_TRUE(view(driver).panes.camera(k, view(driver).camera) == before.camera(k, front));
    }
}

TEST(Views, commands_act_on_the_picture_that_was_pressed_last) {
    Driver driver(setup());
    EXPECT_DONE(driver.press("6"));
    EXPECT_EQ(view(driver).panes.active(), 0);
    point_at_picture(driver, 1);
    driver.button(0, true);
    driver.button(0, false);
    EXPECT_EQ(view(driver).panes.active(), 1);
    EXPECT_DONE(driver.press("Ctrl+Keypad 1"));
    EXPECT_EQ(standpoint_of(view(driver).camera), Standpoint::back);
    EXPECT_FALSE(standpoint_of(view(driver).panes.camera(0, view(driver).camera)));
    EXPECT_DONE(driver.press("6"));
    EXPECT_EQ(view(driver).panes.count(), 1);
    EXPECT_EQ(standpoint_of(view(driver).camera), Standpoint::back) << "the active picture is the one that stays";
}

TEST(Views, a_luminaire_is_dragged_in_the_plan_of_four_pictures) {
    Driver driver(setup());
    ASSERT_TRUE(driver.wait_settled());
    EXPECT_DONE(driver.press("7"));
    EXPECT_DONE(driver.click("tree." + panel));
    const Vec3 before = place(driver, panel);
    EXPECT_DONE(driver.drag_object(panel, {1.0, -0.5, 0.0}));
    EXPECT_NEAR(place(driver, panel).x, before.x + 1.0, 0.051);  // half a step of the raster
    EXPECT_NEAR(place(driver, panel).y, before.y - 0.5, 0.051);
    EXPECT_EQ(place(driver, panel).z, before.z);
    EXPECT_EQ(state(driver, "undo depth"), "1");
}

TEST(Views, a_picture_has_a_menu_of_where_from_and_of_which_light) {
    Driver driver(setup());
    EXPECT_DONE(driver.press("6"));
    EXPECT_DONE(driver.click("pane.2"));
    EXPECT_DONE(driver.click("pane.Left"));
    EXPECT_EQ(standpoint_of(view(driver).camera), Standpoint::left);
    EXPECT_DONE(driver.click("pane.2"));
    EXPECT_DONE(driver.click("pane.Direct light"));
    EXPECT_EQ(view(driver).panes.part(0, view(driver).options.part), LightPart::total);
    EXPECT_EQ(view(driver).panes.part(1, view(driver).options.part), LightPart::direct);
    EXPECT_DONE(driver.click("pane.1"));
    EXPECT_DONE(driver.click("pane.alone"));
    EXPECT_EQ(view(driver).panes.count(), 1);
    EXPECT_EQ(state(driver, "part"), "total");
}

TEST(Views, the_divider_moves_and_a_double_click_makes_pictures_even) {
    Driver driver(setup());
    EXPECT_DONE(driver.press("6"));
    const float even = view(driver).panes.pane(0).width;
    EXPECT_DONE(driver.drag("view.divider", 80.0F, 0.0F));
    EXPECT_NEAR(view(driver).panes.pane(0).width, even + 80.0F, 2.0F);
    EXPECT_EQ(standpoint_of(view(driver).camera), std::nullopt) << "the divider is no place to turn the view";
    EXPECT_DONE(driver.double_click("view.divider"));
    EXPECT_NEAR(view(driver).panes.pane(0).width, even, 2.0F);
}

TEST(Views, a_plan_is_shifted_by_the_left_button_and_turned_by_the_right_one) {
    Driver driver(setup());
    EXPECT_DONE(driver.press("P"));
    EXPECT_EQ(standpoint_of(view(driver).camera), Standpoint::plan);
    const Vec3 before = view(driver).camera.target;
    point_at_picture(driver, 0);
    driver.point_at(260.0F, 540.0F);  // beside the room
    driver.button(0, true);
    driver.point_at(290.0F, 540.0F);
    driver.point_at(320.0F, 540.0F);
    driver.button(0, false);
    EXPECT_EQ(standpoint_of(view(driver).camera), Standpoint::plan);
    EXPECT_LT(view(driver).camera.target.x, before.x - 0.1);
    driver.button(1, true);
    driver.point_at(340.0F, 500.0F);
    driver.button(1, false);
    EXPECT_FALSE(standpoint_of(view(driver).camera));
    EXPECT_FALSE(view(driver).camera.orthographic);
}

TEST(Views, the_projection_changes_and_what_is_in_the_middle_keeps_its_size) {
    Driver driver(setup());
    const Camera before = view(driver).camera;
    EXPECT_DONE(driver.press("Keypad 5"));
    EXPECT_TRUE(view(driver).camera.orthographic);
    EXPECT_NEAR(picture_height_at(view(driver).camera, before.target), picture_height_at(before, before.target), 1e-9);
    EXPECT_DONE(driver.press("Keypad 5"));
    EXPECT_TRUE(view(driver).camera == before);
}

TEST(Views, the_ceiling_and_a_section_are_kept_with_a_view_and_recalled) {
    Driver driver(setup());
    EXPECT_DONE(driver.press("U"));
    EXPECT_DONE(driver.press("K"));
    ASSERT_TRUE(view(driver).camera.left_out.cut);
    EXPECT_DONE(driver.drag("section.handle", 0.0F, -30.0F));
    const LeftOut left_out = view(driver).camera.left_out;
    EXPECT_GT(left_out.cut->offset, 1.25) << "dragged up";
    EXPECT_DONE(driver.press("Ctrl+K"));
    EXPECT_EQ(state(driver, "undo"), "Keep view");
    EXPECT_DONE(driver.press("Ctrl+1"));
    EXPECT_FALSE(view(driver).camera.left_out == left_out);
    EXPECT_DONE(driver.press("Ctrl+5"));  // the room has four of its own
    EXPECT_TRUE(view(driver).camera.left_out == left_out);
    EXPECT_DONE(driver.click("view.views"));
    EXPECT_DONE(driver.click("section.on"));
    EXPECT_FALSE(view(driver).camera.left_out.cut);
    EXPECT_TRUE(view(driver).camera.left_out.ceiling);
}

TEST(Views, framing_shows_what_is_selected_from_the_same_direction) {
    Driver driver(setup());
    const Vec3 forward = axes_of(view(driver).camera).forward;
    EXPECT_DONE(driver.click("tree.Cooler"));
    EXPECT_DONE(driver.press("F"));
    EXPECT_LT(glm::distance(axes_of(view(driver).camera).forward, forward), 1e-6);
    EXPECT_LT(picture_height_at(view(driver).camera, view(driver).camera.target), 3.0) << "as large as can be";
    const auto at = driver.workbench().viewport().on_screen(place(driver, "Cooler"));
    ASSERT_TRUE(at);
    EXPECT_TRUE(view(driver).panes.pane(0).holds(*at));
}

}  // namespace
}  // namespace hanei
