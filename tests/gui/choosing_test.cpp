#include "computer_room.h"
#include "engine/edit/several.h"
#include "ui/panels/state_text.h"
#include "ui/window/driver.h"
#include "ui/window/script.h"

#include <gtest/gtest.h>
#include <sstream>

namespace hanei {
namespace {

std::string state(const Driver& driver, const std::string& name) { return state_of(driver.workbench())[name]; }

#define EXPECT_DONE(action) EXPECT_EQ(action, "")

TEST(Choosing, every_object_that_is_seen_is_chosen_by_a_click_on_it) {
    Driver driver(computer_room());
    const SceneSnapshot scene = driver.workbench().document().shown();
    int chosen = 0;
    for (const ObjectId id : all_objects(*scene)) {
        const ObjectKind kind = kind_of(*scene, id);
        if (kind == ObjectKind::grid || kind == ObjectKind::point) continue;
        const std::string name = display_name(*scene, id);
        if (!driver.click_object(name).empty()) continue;  // others hide it
        EXPECT_EQ(state(driver, "selected"), name);
        ++chosen;
    }
    EXPECT_GE(chosen, 6);
}

TEST(Choosing, by_a_box_and_shift_and_moving_them_is_one_step) {
    Driver driver(computer_room());
    const SceneSnapshot before = driver.workbench().document().shown();
    EXPECT_DONE(driver.press("P"));
    EXPECT_DONE(driver.press("Ctrl+A"));
    const std::string all = state(driver, "selected count");
    EXPECT_DONE(driver.press("Esc"));
    const ScreenRect view = *driver.workbench().widgets().find("view");
    driver.drag_over({view.left + 3.0F, view.top + 3.0F}, {view.right - 3.0F, view.bottom - 3.0F}, {false, true});
    const int boxed = std::stoi(state(driver, "selected count"));
    EXPECT_GE(boxed, 6) << "of " << all;
    EXPECT_DONE(driver.press("Up"));
    EXPECT_EQ(state(driver, "undo depth"), "1");
    EXPECT_EQ(state(driver, "undo"), "Move " + std::to_string(boxed) + " objects");
    EXPECT_DONE(driver.press("Ctrl+Z"));
    EXPECT_EQ(*driver.workbench().document().shown(), *before);
}

TEST(Choosing, in_the_tree_takes_ranges_and_single_rows) {
    Driver driver(computer_room());
    EXPECT_DONE(driver.click("tree.Ceiling panel 1"));
    EXPECT_DONE(driver.click("tree.Ceiling panel 2", 0, {false, true, false}));
    EXPECT_EQ(state(driver, "selected count"), "2");
    EXPECT_EQ(state(driver, "selected"), "Ceiling panel 2");
    EXPECT_DONE(driver.click("tree.Cooler", 0, {true, false, false}));
    EXPECT_EQ(state(driver, "selected count"), "3");
    EXPECT_DONE(driver.click("tree.Cooler", 0, {true, false, false}));
    EXPECT_EQ(state(driver, "selected count"), "2");
    EXPECT_DONE(driver.press("Delete"));
    EXPECT_EQ(state(driver, "undo"), "Delete 2 luminaires");
    EXPECT_EQ(state(driver, "luminaires"), "0");
    EXPECT_EQ(state(driver, "selected count"), "0");
}

TEST(Choosing, all_of_a_kind_and_turning_them_together) {
    Driver driver(computer_room());
    EXPECT_DONE(driver.click("tree.Ceiling panel 1"));
    EXPECT_DONE(driver.press("Ctrl+Shift+A"));
    EXPECT_EQ(state(driver, "selected count"), "2");
    EXPECT_DONE(driver.press("T"));
    EXPECT_EQ(state(driver, "undo"), "Turn 2 luminaires by 90 degrees");
    EXPECT_DONE(driver.press("Ctrl+D"));
    EXPECT_EQ(state(driver, "undo"), "Duplicate 2 luminaires");
    EXPECT_EQ(state(driver, "luminaires"), "4");
    EXPECT_EQ(state(driver, "selected count"), "2");
}

TEST(AScript, clicks_with_keys_held_and_draws_boxes) {
    Driver driver(computer_room());
    std::ostringstream out;
    const auto fault = play_script(
        "key P\nclick object \"Ceiling panel 1\"\nclick object \"Ceiling panel 2\" with Shift\n"
        "expect \"selected count\" 2\nbox 290 100 830 560\n",
        "choose", driver, out);
    ASSERT_FALSE(fault) << to_text(*fault);
    EXPECT_GT(std::stoi(state(driver, "selected count")), 2);
    EXPECT_TRUE(play_script("click Cooler with Hyper\n", "choose", driver, out));
    EXPECT_TRUE(play_script("box 1 2 3\n", "choose", driver, out));
}

}  // namespace
}  // namespace hanei
