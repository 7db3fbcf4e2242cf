#include "app/desktop.h"
#include "app/user_folders.h"
#include "engine/edit/edit.h"
#include "ui/panels/state_text.h"
#include "ui/window/driver.h"

#include <gtest/gtest.h>

namespace hanei {
namespace {

#define EXPECT_DONE(action) EXPECT_EQ(action, "")

class ThePreferences : public testing::Test {
protected:
    ThePreferences()
        : folder(std::filesystem::path(testing::TempDir()) / "hanei user" /
                 testing::UnitTest::GetInstance()->current_test_info()->name()) {  // tests run side by side
        std::filesystem::remove_all(folder);
    }
    Driver::Setup setup(const std::filesystem::path& file = {}) const {
        ProjectDoor door = project_door();
        door.user = user_door(*user_folders(folder));
        return {{empty_room(), {}}, file, std::move(door)};
    }
    std::filesystem::path room(const std::string& name) const {
        const std::filesystem::path file = folder / name;
        std::filesystem::create_directories(folder);
        EXPECT_FALSE(project_door().save({with_panel_luminaire(empty_room()).scene, {}}, file));
        return file;
    }
    std::filesystem::path folder;
};

TEST_F(ThePreferences, chosen_in_their_dialog_are_there_at_the_next_start) {
    {
        Driver driver(setup());
        EXPECT_DONE(driver.press("Ctrl+,"));
        EXPECT_DONE(driver.click("preferences.autosave"));
        driver.type("15");
        EXPECT_DONE(driver.press("Enter"));
        EXPECT_DONE(driver.click("preferences.layout"));
        EXPECT_DONE(driver.click("preferences.close"));
        EXPECT_EQ(driver.workbench().widgets().find("preferences.close"), nullptr);
    }
    Driver driver(setup());
    EXPECT_EQ(driver.workbench().preferences().autosave, 15.0);
    EXPECT_FALSE(driver.workbench().preferences().restores_layout);
}

TEST_F(ThePreferences, remember_how_wide_panels_were_dragged) {
    Preferences usual;
    {
        Driver driver(setup());
        const ScreenRect view = *driver.workbench().widgets().find("view");
        driver.point_at(usual.left_width - 3.0F, view.y());
        driver.button(0, true);
        driver.point_at(usual.left_width + 57.0F, view.y());
        driver.button(0, false);
    }
    Driver driver(setup());
    EXPECT_NEAR(driver.workbench().preferences().left_width, usual.left_width + 60.0F, 1.5F);
}

TEST_F(ThePreferences, list_the_projects_opened_last_and_open_them_again) {
    const std::filesystem::path a = room("a.hanei"), b = room("b.hanei"), gone = room("gone.hanei");
    for (const auto& file : {gone, b, a}) Driver driver(setup(file));
    std::filesystem::remove(gone);
    Driver driver(setup());
    EXPECT_EQ(driver.workbench().preferences().recent, (std::vector{a, b, gone}));
    EXPECT_DONE(driver.click("menu.File"));
    EXPECT_DONE(driver.click("file.recent"));
    EXPECT_DONE(driver.click("recent.gone.hanei"));  // grey: nothing happens
    EXPECT_EQ(driver.workbench().document().file(), "");
    EXPECT_DONE(driver.click("recent.b.hanei"));
    EXPECT_EQ(driver.workbench().document().file(), b);
    EXPECT_EQ(driver.workbench().preferences().recent.front(), b);
}

TEST_F(ThePreferences, of_one_user_are_not_touched_by_scripts) {
    Driver driver({{empty_room(), {}}, room("a.hanei"), project_door()});
    EXPECT_DONE(driver.press("Ctrl+,"));
    EXPECT_DONE(driver.click("preferences.layout"));
    EXPECT_DONE(driver.press("Esc"));
    EXPECT_FALSE(std::filesystem::exists(folder / "preferences.json"));
}

TEST_F(ThePreferences, are_not_lost_over_a_disk_that_refuses) {
    std::filesystem::create_directories(folder / "preferences.json");  // a folder is in the way
    Driver driver(setup());
    EXPECT_DONE(driver.press("Ctrl+,"));
    EXPECT_DONE(driver.click("preferences.layout"));
    EXPECT_FALSE(driver.workbench().preferences().restores_layout);
    EXPECT_EQ(state_of(driver.workbench())["message"], "Preferences could not be kept");
    EXPECT_EQ(driver.workbench().messages().unread_errors(), 1U);
}

}  // namespace
}  // namespace hanei
