/// Accuracy against time at the desk: a sweep beside the frames, its points used by a click, presets.
#include "app/desktop.h"
#include "ui/window/driver.h"

#include <gtest/gtest.h>

namespace hanei {
namespace {

class Studying : public testing::Test {
protected:
    Driver::Setup setup() {
        Opened<ProjectContent> opened =
            project_door().open(std::filesystem::path(HANEI_SOURCE) / "assets/rooms/painted-room.hanei");
        EXPECT_TRUE(opened.content);
        opened.content->settings.max_patch = 2.0;
        ProjectDoor door = project_door();
        door.user.keep_learned = [this](const std::vector<CalibrationSample>& learned) { learned_ = learned; };
        return {*opened.content, "room.hanei", door};
    }
    const StudyPanel& panel() const { return driver_.workbench().readings().study; }
    const Settings& settings() const { return driver_.workbench().document().settings(); }

    std::vector<CalibrationSample> learned_;
    Driver driver_{setup()};
};

#define EXPECT_DONE(action) EXPECT_EQ(action, "")

TEST_F(Studying, a_click_on_a_point_of_the_plot_uses_its_settings_as_one_step) {
    ASSERT_TRUE(driver_.wait_settled());
    EXPECT_DONE(driver_.click("tab.Study"));
    EXPECT_DONE(driver_.click("study.start"));
    const auto another = [&]() -> std::optional<std::size_t> {
        const auto& points = panel().sweep().points;
        for (std::size_t k = 0; k < points.size(); ++k)
            if (points[k].shadows && points[k].complete && points[k].settings.method == Method::paper_closed) return k;
        return std::nullopt;
    };
    ASSERT_TRUE(driver_.wait_until([&] { return another().has_value(); }));
    EXPECT_DONE(driver_.click("study.cancel"));
    EXPECT_FALSE(panel().busy());
    driver_.frames(2);
    const std::size_t depth = driver_.workbench().document().history().depth();
    const std::string widget = "study.point." + std::to_string(*another());
    const Settings before = settings();
    EXPECT_DONE(driver_.click(widget));
    driver_.frames(3);
    EXPECT_NE(settings(), before);
    bool is_of_a_run = false;  // points may lie on each other: the nearest is taken
    for (const SweepPoint& point : panel().sweep().points) is_of_a_run = is_of_a_run || point.settings == settings();
    EXPECT_TRUE(is_of_a_run);
    EXPECT_EQ(driver_.workbench().document().history().depth(), depth + 1);
    EXPECT_DONE(driver_.press("Ctrl+Z"));
    EXPECT_EQ(settings(), before);
}

TEST_F(Studying, a_preset_of_the_calculation_panel_is_one_step) {
    ASSERT_TRUE(driver_.wait_settled());
    EXPECT_DONE(driver_.click("tab.Calculation"));
    driver_.frames(2);
    const Settings before = settings();
    const std::size_t depth = driver_.workbench().document().history().depth();
    EXPECT_DONE(driver_.click("preset.design"));
    driver_.frames(3);
    EXPECT_NE(settings(), before);
    EXPECT_EQ(settings(), settings_for(*driver_.workbench().document().shown(), before, Preset::design, {}).settings);
    EXPECT_EQ(driver_.workbench().document().history().depth(), depth + 1);
    EXPECT_DONE(driver_.press("Ctrl+Z"));
    EXPECT_EQ(settings(), before);
}

}  // namespace
}  // namespace hanei
