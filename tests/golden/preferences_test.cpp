#include "app/preferences_file.h"
#include "app/user_folders.h"
#include "engine/base/whole_file.h"

#include <cstdlib>
#include <fstream>
#include <gtest/gtest.h>

namespace hanei {
namespace {

Preferences unusual() {
    Preferences wished;
    wished.language = Language::japanese;
    wished.theme = Theme::light;
    wished.scale = 1.75;
    wished.length = LengthUnit::feet_inches;
    wished.illuminance = IlluminanceUnit::foot_candle;
    wished.left_width = 301.0F;
    wished.right_width = 333.5F;
    wished.bottom_height = 120.25F;
    wished.recent = {"/rooms/b.hanei", "/rooms/a \"new\".hanei"};
    wished.autosave = 20.0;
    wished.picture_name = "{part} {number}";
    wished.restores_layout = true;
    return wished;
}

std::filesystem::path fresh(const std::string& name) {
    const auto folder = std::filesystem::path(testing::TempDir()) / "hanei preferences" / name;
    std::filesystem::remove_all(folder);
    return folder;
}

TEST(Preferences, come_back_as_they_were_kept) {
    const auto file = fresh("kept") / "deep/preferences.json";
    EXPECT_FALSE(write_preferences(unusual(), file));
    const UserDoor::Opened opened = read_preferences(file);
    EXPECT_TRUE(opened.findings.empty());
    EXPECT_EQ(opened.preferences, unusual());
}

TEST(Preferences, of_a_first_start_are_the_usual_without_a_remark) {
    const UserDoor::Opened opened = read_preferences(fresh("none") / "preferences.json");
    EXPECT_EQ(opened.preferences, Preferences{});
    EXPECT_TRUE(opened.findings.empty());
}

TEST(Preferences, that_make_no_sense_are_the_usual_each_with_a_remark) {
    const UserDoor::Opened opened = preferences_of_text(
        R"({"language": "klingon", "theme": 7, "scale": 1e99, "autosave_s": -1, "left_width": "wide",
            "right_width": 300, "recent": ["relative.hanei", "/rooms/a.hanei", "/rooms/a.hanei"]})",
        "p.json");
    EXPECT_EQ(opened.findings.size(), 5U);
    for (const Diagnostic& finding : opened.findings) {
        EXPECT_EQ(finding.severity, Severity::warning);
        EXPECT_EQ(finding.place.file, "p.json");
        EXPECT_GT(finding.place.line, 0);
    }
    Preferences expected;
    expected.right_width = 300.0F;
    expected.recent = {"/rooms/a.hanei"};
    EXPECT_EQ(opened.preferences, expected);
}

TEST(Preferences, of_a_broken_file_are_the_usual) {
    for (const char* const text : {"", "{", "[]", "null", "\x00\xff\xfe", "{\"scale\": nan}", "[[[[[[[[[["}) {
        const UserDoor::Opened opened = preferences_of_text(text, "p.json");
        EXPECT_EQ(opened.preferences, Preferences{}) << text;
        EXPECT_FALSE(opened.findings.empty()) << text;
    }
    const auto folder = fresh("folder");
    std::filesystem::create_directories(folder);
    EXPECT_EQ(read_preferences(folder).findings.size(), 1U);
}

TEST(Preferences, of_a_newer_program_are_kept_for_it) {
    const UserDoor::Opened opened = preferences_of_text(R"({"theme": "light", "walls": {"colour": [1, 2]}})", "p.json");
    EXPECT_TRUE(opened.findings.empty());
    const UserDoor::Opened again = preferences_of_text(preferences_text(opened.preferences), "p.json");
    EXPECT_EQ(again.preferences, opened.preferences);
    EXPECT_NE(preferences_text(again.preferences).find("\"walls\""), std::string::npos);
}

TEST(Preferences, leave_the_panels_as_usual_when_their_sizes_are_not_wished) {
    Preferences wished = unusual();
    wished.restores_layout = false;
    const UserDoor::Opened opened = preferences_of_text(preferences_text(wished), "p.json");
    EXPECT_EQ(opened.preferences.left_width, Preferences{}.left_width);
    EXPECT_EQ(opened.preferences.theme, Theme::light);
}

TEST(Preferences, are_kept_where_the_system_says) {
    ::setenv("XDG_CONFIG_HOME", "/config", 1);
    ::setenv("XDG_STATE_HOME", "relative is overlooked", 1);
    ::setenv("HOME", "/home/somebody", 1);
    EXPECT_EQ(user_folders({})->preferences, "/config/hanei/preferences.json");
    EXPECT_EQ(user_folders({})->recovery, "/home/somebody/.local/state/hanei/recovery");
    EXPECT_EQ(user_folders("/elsewhere")->preferences, "/elsewhere/preferences.json");
    ::unsetenv("XDG_CONFIG_HOME");
    ::unsetenv("HOME");
    EXPECT_FALSE(user_folders({}));
}

}  // namespace
}  // namespace hanei
