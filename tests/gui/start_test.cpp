#include "app/desktop.h"
#include "app/user_folders.h"
#include "engine/edit/edit.h"
#include "ui/panels/state_text.h"
#include "ui/window/driver.h"

#include <gtest/gtest.h>

namespace hanei {
namespace {

#define EXPECT_DONE(action) EXPECT_EQ(action, "")

namespace fs = std::filesystem;

/// A launch without a project, of a user who opened two rooms before, one of which is gone.
class TheStartPage : public testing::Test {
protected:
    TheStartPage() : folder(fs::path(testing::TempDir()) / "hanei start" / name_of_test()) {
        fs::remove_all(folder);
        fs::create_directories(folder);
        Scene scene = empty_room();
        scene.title = "of before";
        EXPECT_FALSE(project_door().save({scene, {}}, folder / "hall.hanei"));
        const UserDoor user = user_door(*user_folders(folder / "user"));
        Preferences wished;
        wished.recent = {folder / "hall.hanei", folder / "gone.hanei"};
        EXPECT_FALSE(user.save_preferences(wished));
    }
    static std::string name_of_test() { return testing::UnitTest::GetInstance()->current_test_info()->name(); }
    Driver::Setup setup() const {
        ProjectDoor door = project_door();
        door.user = user_door(*user_folders(folder / "user"));
        return {{with_panel_luminaire(empty_room()).scene, {}}, {}, std::move(door)};
    }
    static std::string state(const Driver& driver, const std::string& name) {
        return state_of(driver.workbench())[name];
    }
    static void launch(Driver& driver) {
        driver.workbench().offer_start();
        driver.frames(3);
    }
    fs::path folder;
};

TEST_F(TheStartPage, leads_to_the_folder_of_hard_cases) {
    Driver driver(setup());
    launch(driver);
    EXPECT_DONE(driver.click("start.hard"));
    driver.frames(3);
    EXPECT_TRUE(driver.workbench().browser().is_open());
    EXPECT_EQ(state(driver, "start page"), "false");
}

TEST_F(TheStartPage, opens_a_project_of_before_by_a_click) {
    Driver driver(setup());
    launch(driver);
    EXPECT_EQ(state(driver, "start page"), "true");
    EXPECT_DONE(driver.click("start.gone"));
    EXPECT_EQ(state(driver, "start page"), "true") << "what is gone cannot be opened";
    EXPECT_DONE(driver.click("start.hall"));
    EXPECT_EQ(state(driver, "start page"), "false");
    EXPECT_EQ(state(driver, "title"), "hall");
}

TEST_F(TheStartPage, is_used_by_the_keyboard_alone) {
    Driver driver(setup());
    launch(driver);
    EXPECT_DONE(driver.press("Right"));
    EXPECT_DONE(driver.press("Enter"));
    EXPECT_EQ(state(driver, "title"), "hall");
    EXPECT_DONE(driver.click("menu.File"));
    EXPECT_DONE(driver.click("file.start_page"));
    EXPECT_EQ(state(driver, "start page"), "true");
    EXPECT_DONE(driver.press("Esc"));
    EXPECT_EQ(state(driver, "start page"), "false");
    EXPECT_EQ(state(driver, "title"), "hall") << "Escape goes on with what is shown";
}

TEST_F(TheStartPage, gives_way_to_a_project_that_is_dropped) {
    Driver driver(setup());
    launch(driver);
    driver.drop({folder / "hall.hanei"}, 600.0F, 400.0F);
    EXPECT_EQ(state(driver, "start page"), "false");
    EXPECT_EQ(state(driver, "title"), "hall");
    EXPECT_DONE(driver.press("Ctrl+N"));
    EXPECT_EQ(state(driver, "asks"), "true") << "keys work again";
}

TEST_F(TheStartPage, begins_a_copy_of_an_example_that_no_saving_can_harm) {
    Driver driver(setup());
    launch(driver);
    EXPECT_DONE(driver.click("start.office"));
    EXPECT_EQ(state(driver, "title"), "Office, eight desks");
    EXPECT_TRUE(driver.workbench().document().file().empty());
    EXPECT_EQ(state(driver, "saved"), "true");
    EXPECT_DONE(driver.press("Ctrl+S"));
    EXPECT_EQ(state(driver, "browser"), "true") << "it asks for a name";
}

TEST_F(TheStartPage, is_left_out_when_the_user_likes_it_so_and_stays_away) {
    {
        Driver driver(setup());
        launch(driver);
        EXPECT_DONE(driver.click("start.always"));
        EXPECT_DONE(driver.click("start.close"));
        driver.frames(3);
    }
    Driver driver(setup());
    launch(driver);
    EXPECT_EQ(state(driver, "start page"), "false");
    EXPECT_FALSE(driver.workbench().preferences().shows_start_page);
}

TEST_F(TheStartPage, gives_way_to_work_that_was_lost) {
    {
        Driver driver(setup());
        EXPECT_DONE(driver.click("tree.Panel 1"));
        EXPECT_DONE(driver.press("Right"));
    }
    Driver driver(setup());
    launch(driver);
    EXPECT_EQ(state(driver, "recovery"), "1");
    EXPECT_EQ(state(driver, "start page"), "false");
}

TEST_F(TheStartPage, leads_to_a_new_room_of_sizes) {
    Driver driver(setup());
    launch(driver);
    EXPECT_DONE(driver.press("Enter"));  // the first thing to begin with
    ASSERT_EQ(state(driver, "asks"), "true");
    EXPECT_DONE(driver.click("new.length"));
    driver.type("7.5");
    EXPECT_DONE(driver.press("Enter"));
    EXPECT_DONE(driver.click("new.ok"));
    EXPECT_EQ(driver.workbench().document().shown()->room->plan[1].x, 7.5);
}

TEST_F(TheStartPage, is_not_needed_for_a_new_project) {
    Driver driver(setup());
    EXPECT_DONE(driver.press("Ctrl+N"));
    ASSERT_EQ(state(driver, "asks"), "true");
    EXPECT_DONE(driver.click("new.begin"));
    EXPECT_DONE(driver.click("new.begin.The plain room"));
    EXPECT_DONE(driver.click("new.ok"));
    EXPECT_EQ(*driver.workbench().document().shown(), empty_room());
    EXPECT_DONE(driver.press("Ctrl+N"));
    EXPECT_DONE(driver.click("new.begin"));
    EXPECT_DONE(driver.click("new.begin.Office"));
    EXPECT_DONE(driver.click("new.ok"));
    EXPECT_EQ(state(driver, "title"), "Office, eight desks");
    EXPECT_DONE(driver.press("Ctrl+N"));
    EXPECT_DONE(driver.press("Esc"));
    EXPECT_EQ(state(driver, "title"), "Office, eight desks");
}

}  // namespace
}  // namespace hanei
