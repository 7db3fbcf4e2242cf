#include "app/desktop.h"
#include "engine/edit/edit.h"
#include "ui/panels/state_text.h"
#include "ui/view/png_text.h"
#include "ui/window/driver.h"

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <gtest/gtest.h>
#include <map>
#include <sys/stat.h>

namespace hanei {
namespace {

#define EXPECT_DONE(action) EXPECT_EQ(action, "")

namespace fs = std::filesystem;

class Exports : public testing::Test {
protected:
    Exports() : folder(fs::path(testing::TempDir()) / "hanei export" / name_of_test()) {
        fs::remove_all(folder);
        fs::create_directories(folder);
    }
    static std::string name_of_test() { return testing::UnitTest::GetInstance()->current_test_info()->name(); }
    Driver::Setup setup() const {
        const Scene scene = with_grid(with_panel_luminaire(empty_room()).scene).scene;
        Settings settings;
        settings.max_patch = 2.0;
        return {{scene, settings}, folder / "room.hanei", project_door()};
    }
    static std::string state(const Driver& driver, const std::string& name) {
        return state_of(driver.workbench())[name];
    }
    static void type_name(Driver& driver, const std::string& name) {
        EXPECT_DONE(driver.click("export.name"));
        driver.type(name);
        EXPECT_DONE(driver.press("Enter"));
    }
    std::vector<std::string> files(const fs::path& where, const std::string& ending) const {
        std::vector<std::string> names;
        for (const auto& entry : fs::directory_iterator(where))
            if (entry.path().extension() == ending) names.push_back(entry.path().filename().string());
        std::sort(names.begin(), names.end());
        return names;
    }
    fs::path folder;
};

TEST_F(Exports, write_a_picture_that_says_what_it_shows) {
    Driver driver(setup());
    ASSERT_TRUE(driver.wait_settled());
    EXPECT_DONE(driver.press("Ctrl+E"));
    type_name(driver, "{project} {part}");
    EXPECT_DONE(driver.click("export.accept"));
    ASSERT_TRUE(driver.wait_until([&] { return state(driver, "message") == "Exported room total.png"; }, 20.0));
    const auto text = read_png_text(folder / "room total.png");
    ASSERT_TRUE(text);
    std::map<std::string, std::string> said(text->begin(), text->end());
    EXPECT_NE(said["Title"].find("Total illuminance"), std::string::npos);
    EXPECT_EQ(said["Software"].substr(0, 5), "Hanei");
    EXPECT_NE(said["Description"].find("Illuminance in lx, logarithmic scale"), std::string::npos);
    EXPECT_NE(said["Description"].find("Error: iteration"), std::string::npos);
    EXPECT_EQ(said["Creation Time"].size(), 20U);
    EXPECT_EQ(said["Hanei project"].size(), 16U);
}

TEST_F(Exports, write_the_difference_while_it_is_shown_and_say_so) {
    Driver driver(setup());
    ASSERT_TRUE(driver.wait_settled());
    EXPECT_DONE(driver.press("Alt+A"));
    driver.workbench().choose(driver.workbench().document().shown()->luminaires.front().id);
    EXPECT_DONE(driver.press("Page Down"));
    ASSERT_TRUE(driver.wait_settled());
    EXPECT_DONE(driver.press("J"));
    EXPECT_DONE(driver.press("Ctrl+E"));
    type_name(driver, "{project} {part}");
    EXPECT_DONE(driver.click("export.accept"));
    ASSERT_TRUE(driver.wait_until([&] { return state(driver, "message") == "Exported room total.png"; }, 20.0));
    const auto text = read_png_text(folder / "room total.png");
    ASSERT_TRUE(text);
    std::map<std::string, std::string> said(text->begin(), text->end());
    EXPECT_NE(said["Title"].find("Difference: Total illuminance"), std::string::npos) << said["Title"];
}

TEST_F(Exports, write_every_chosen_part_in_the_size_that_is_asked_for_and_compute_what_is_missing) {
    Driver driver(setup());
    ASSERT_TRUE(driver.wait_settled());
    EXPECT_DONE(driver.press("Ctrl+E"));
    EXPECT_DONE(driver.click("export.what"));
    EXPECT_DONE(driver.click("export.what.A picture of each chosen part"));
    ASSERT_NE(driver.workbench().widgets().find("export.unshadowed"), nullptr) << "the choice did not take";
    EXPECT_DONE(driver.click("export.unshadowed"));
    type_name(driver, "{part} {number}");
    EXPECT_DONE(driver.click("export.accept"));
    ASSERT_TRUE(driver.wait_until([&] { return state(driver, "message") == "Exported 4 pictures"; }, 60.0));
    EXPECT_EQ(files(folder, ".png"),
              (std::vector<std::string>{"direct 2.png", "interreflected 3.png", "total 1.png", "unshadowed 4.png"}));
}

TEST_F(Exports, warn_before_a_file_is_replaced_and_refuse_names_without_sense) {
    std::ofstream(folder / "there.png") << "mine";
    Driver driver(setup());
    ASSERT_TRUE(driver.wait_settled());
    EXPECT_DONE(driver.press("Ctrl+E"));
    type_name(driver, "there.png");
    EXPECT_DONE(driver.press("Enter"));  // the key alone replaces nothing
    driver.frames(5);
    EXPECT_EQ(fs::file_size(folder / "there.png"), 4U);
    type_name(driver, "{lumen}");
    EXPECT_NE(driver.workbench().widgets().find("export.fault"), nullptr);
    EXPECT_DONE(driver.click("export.accept"));
    driver.frames(5);
    type_name(driver, "there.png");
    EXPECT_DONE(driver.click("export.accept"));
    ASSERT_TRUE(driver.wait_until([&] { return state(driver, "message") == "Exported there.png"; }, 20.0));
    EXPECT_TRUE(read_png_text(folder / "there.png"));
}

TEST_F(Exports, that_a_disk_refuses_are_told_and_listed) {
    Driver driver(setup());
    ASSERT_TRUE(driver.wait_settled());
    EXPECT_DONE(driver.press("Ctrl+E"));
    type_name(driver, "way.png");
    fs::create_directories(folder / "way.png/in the way");
    EXPECT_DONE(driver.click("export.accept"));
    ASSERT_TRUE(driver.wait_until([&] { return state(driver, "dialog") == "findings"; }, 20.0));
    EXPECT_NE(state(driver, "finding").find("no plain file"), std::string::npos);
    EXPECT_EQ(driver.workbench().messages().entries().back().source, "Export");
    EXPECT_EQ(driver.workbench().messages().unread_errors(), 1U);
    EXPECT_DONE(driver.click("findings.ok"));
    EXPECT_DONE(driver.click("status.errors"));
    EXPECT_EQ(driver.workbench().messages().unread_errors(), 0U);
    EXPECT_NE(driver.workbench().widgets().find("message.1"), nullptr);
}

TEST_F(Exports, values_as_the_command_line_writes_them) {
    Driver driver(setup());
    ASSERT_TRUE(driver.wait_settled());
    EXPECT_DONE(driver.click("menu.File"));
    EXPECT_DONE(driver.click("file.export_values"));
    EXPECT_DONE(driver.press("Enter"));
    EXPECT_EQ(state(driver, "message"), "Exported room.csv");
    std::ifstream stream(folder / "room.csv");
    std::string head;
    std::getline(stream, head);
    EXPECT_EQ(head.rfind("kind,name,x_m", 0), 0U);
}

TEST_F(Exports, record_a_drag_as_numbered_pictures_with_an_index) {
    Driver driver(setup());
    ASSERT_TRUE(driver.wait_settled());
    EXPECT_DONE(driver.press("P"));
    EXPECT_DONE(driver.click("menu.File"));
    EXPECT_DONE(driver.click("file.record"));
    EXPECT_DONE(driver.drag_object("Panel 1", {1.0, 0.5, 0.0}));
    ASSERT_TRUE(driver.wait_settled());
    EXPECT_DONE(driver.click("recording.cancel"));
    fs::path where;
    for (const auto& entry : fs::directory_iterator(folder))
        if (entry.is_directory()) where = entry.path();
    ASSERT_FALSE(where.empty());
    const std::vector<std::string> pictures = files(where, ".png");
    EXPECT_GE(pictures.size(), 10U);
    EXPECT_EQ(pictures.front(), "frame-00001.png");
    std::ifstream stream(where / "index.csv");
    const std::string index{std::istreambuf_iterator<char>(stream), {}};
    EXPECT_EQ(static_cast<std::size_t>(std::count(index.begin(), index.end(), '\n')), pictures.size() + 1);
    EXPECT_NE(index.find("while it is changed"), std::string::npos);
    EXPECT_NE(index.find("complete, iteration error"), std::string::npos);
}

TEST_F(Exports, hand_the_picture_to_the_clipboard_tool_or_say_what_is_missing) {
    const std::string path = std::getenv("PATH");
    ::unsetenv("WAYLAND_DISPLAY");
    ::setenv("DISPLAY", ":none", 1);
    ::setenv("PATH", folder.c_str(), 1);
    Driver driver(setup());
    ASSERT_TRUE(driver.wait_settled());
    EXPECT_DONE(driver.press("Ctrl+Shift+C"));
    EXPECT_NE(state(driver, "finding").find("install the package xclip"), std::string::npos)
        << state(driver, "finding");
    EXPECT_DONE(driver.click("findings.ok"));
    std::ofstream(folder / "xclip") << "#!/bin/sh\n/bin/cat >'" << (folder / "clipboard.png").string() << "'\n";
    ASSERT_EQ(::chmod((folder / "xclip").c_str(), 0755), 0);
    EXPECT_DONE(driver.press("Ctrl+Shift+C"));
    ::setenv("PATH", path.c_str(), 1);
    EXPECT_EQ(state(driver, "message"), "Copied the picture");
    EXPECT_TRUE(read_png_text(folder / "clipboard.png"));
}

}  // namespace
}  // namespace hanei
