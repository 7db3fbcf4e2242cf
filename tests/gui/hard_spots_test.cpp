/// What is hard in a scene is asked for at the desk, and each finding leads to its object.
#include "app/desktop.h"
#include "engine/edit/edit.h"
#include "ui/panels/state_text.h"
#include "ui/window/driver.h"

#include <gtest/gtest.h>

namespace hanei {
namespace {

#define EXPECT_DONE(action) EXPECT_EQ(action, "")

Scene room_with_a_point_in_its_corner() {
    Scene scene = with_panel_luminaire(empty_room()).scene;
    CalculationPoint point;
    point.id = scene.new_id();
    point.name = "In the corner";
    scene.points = {point};
    return scene;
}

TEST(HardSpotsList, stands_in_the_messages_once_it_was_asked_for_and_a_click_selects_the_object) {
    Driver driver({{room_with_a_point_in_its_corner(), {}}, {}, project_door()});
    driver.frames(3);
    EXPECT_EQ(driver.workbench().widgets().find("message.1"), nullptr);
    EXPECT_DONE(driver.click("menu.Results"));
    EXPECT_DONE(driver.click("results.check"));
    driver.frames(3);
    EXPECT_EQ(state_of(driver.workbench())["selected"], "");
    EXPECT_DONE(driver.click("message.2"));
    EXPECT_NE(state_of(driver.workbench())["selected"], "");
    EXPECT_DONE(driver.click("messages.clear"));
    driver.frames(2);
    EXPECT_EQ(driver.workbench().widgets().find("message.1"), nullptr);
}

}  // namespace
}  // namespace hanei
