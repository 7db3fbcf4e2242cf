/// Reading the light at the desk: scale, pins, why, states compared, profile, histogram.
#include "app/desktop.h"
#include "engine/edit/edit.h"
#include "ui/panels/state_text.h"
#include "ui/window/driver.h"

#include <gtest/gtest.h>

namespace hanei {
namespace {

std::filesystem::path room_file() {
    return std::filesystem::path(HANEI_SOURCE) / "assets/rooms/computer-room-panels.hanei";
}

class Reading : public testing::Test {
protected:
    static Driver::Setup setup() {
        Opened<ProjectContent> opened = project_door().open(room_file());
        EXPECT_TRUE(opened.content);
        opened.content->settings.max_patch = 1.5;
        const auto folder = std::filesystem::path(testing::TempDir()) / "hanei readings";
        std::filesystem::create_directories(folder);
        return {*opened.content, folder / "room.hanei", project_door()};
    }
    std::string state(const std::string& name) const { return state_of(driver_.workbench())[name]; }
    double figure(const std::string& name) const { return std::stod(state(name)); }
    const Scene& scene() const { return *driver_.workbench().document().shown(); }

    /// The pointer over the middle of the view.
    void point_at_the_room() {
        driver_.frames(1);
        const ScreenRect view = *driver_.workbench().widgets().find("view");
        driver_.point_at(view.x(), view.y());
        driver_.frames(2);
    }

    Driver driver_{setup()};
};

#define EXPECT_DONE(action) EXPECT_EQ(action, "")

TEST_F(Reading, the_scale_is_typed_in_its_legend_as_one_step_and_kept_with_the_project) {
    ASSERT_TRUE(driver_.wait_settled());
    const double low = figure("range.low");
    EXPECT_DONE(driver_.double_click("legend.low"));
    driver_.type("55");
    EXPECT_DONE(driver_.press("Enter"));
    driver_.frames(2);
    EXPECT_EQ(figure("range.low"), 55.0);
    EXPECT_EQ(state("undo depth"), "1");
    EXPECT_EQ(state("undo"), "Change the scale");
    ASSERT_TRUE(scene().colour_scale);
    EXPECT_DONE(driver_.press("Ctrl+Z"));
    driver_.frames(2);
    EXPECT_FALSE(scene().colour_scale);
    EXPECT_EQ(figure("range.low"), low);
}

TEST_F(Reading, an_end_of_the_scale_is_dragged_as_one_step) {
    ASSERT_TRUE(driver_.wait_settled());
    const double high = figure("range.high");
    EXPECT_DONE(driver_.drag("legend.top", 0.0F, -40.0F));
    EXPECT_GT(figure("range.high"), high);
    EXPECT_EQ(state("undo depth"), "1");
    EXPECT_DONE(driver_.click("legend.steps"));
    EXPECT_DONE(driver_.click("legend.linear"));
    driver_.frames(2);
    EXPECT_EQ(state("scale steps"), "linear");
    EXPECT_EQ(state("undo depth"), "2");
}

TEST_F(Reading, a_pin_stands_where_the_pointer_was_and_is_one_step) {
    ASSERT_TRUE(driver_.wait_settled());
    const std::size_t points = scene().points.size();
    point_at_the_room();
    ASSERT_TRUE(driver_.workbench().viewport().probe());
    const Probe probe = *driver_.workbench().viewport().probe();
    EXPECT_DONE(driver_.press("X"));
    ASSERT_EQ(scene().points.size(), points + 1);
    const CalculationPoint& pin = scene().points.back();
    EXPECT_EQ(pin.name, "Pin 1");
    EXPECT_EQ(pin.position, probe.position);
    EXPECT_EQ(pin.normal, probe.normal);
    EXPECT_EQ(state("selected"), "Pin 1");
    ASSERT_TRUE(driver_.wait_settled());
    EXPECT_NEAR(figure("point Pin 1"), probe.value.total().value, 0.01 * probe.value.total().value);
    EXPECT_DONE(driver_.press("Ctrl+Z"));
    EXPECT_EQ(scene().points.size(), points);
}

TEST_F(Reading, why_it_is_bright_adds_up_to_what_the_chosen_point_reports) {
    ASSERT_TRUE(driver_.wait_settled());
    const CalculationPoint& point = scene().points.front();
    driver_.workbench().choose(point.id);
    EXPECT_DONE(driver_.click("tab.Why"));
    ASSERT_TRUE(driver_.wait_until([&] { return !state("why total").empty(); }));
    EXPECT_NEAR(figure("why total"), figure("point " + point.name), 0.01 * figure("why total"));
    const std::string first = state("why first luminaire"), total = state("why total");
    EXPECT_DONE(driver_.click("why.0." + first));
    EXPECT_EQ(state("selected"), first);
    driver_.frames(2);
    EXPECT_EQ(state("why total"), total) << "what lights the place is chosen without leaving it";
}

TEST_F(Reading, states_are_kept_flipped_and_subtracted) {
    ASSERT_TRUE(driver_.wait_settled());
    EXPECT_DONE(driver_.press("Alt+A"));
    EXPECT_EQ(state("kept states"), "1");
    EXPECT_DONE(driver_.drag_object("Ceiling panel 1", {0.8, 0.0, 0.0}));
    ASSERT_TRUE(driver_.wait_settled());
    const SceneSnapshot moved = driver_.workbench().document().shown();
    driver_.frames(2);
    EXPECT_EQ(state("shows"), "now");
    EXPECT_DONE(driver_.press("J"));
    driver_.frames(2);
    EXPECT_EQ(state("shows"), "difference");
    EXPECT_TRUE(driver_.workbench().widgets().find("difference_legend"));
    EXPECT_FALSE(driver_.workbench().widgets().find("legend"));
    EXPECT_DONE(driver_.press("Alt+B"));
    EXPECT_DONE(driver_.click("compare.a"));
    driver_.frames(2);
    EXPECT_EQ(state("shows"), "kept");
    EXPECT_EQ(driver_.workbench().document().shown(), moved) << "looking at a kept state edits nothing";
    EXPECT_DONE(driver_.click("compare.now"));
    EXPECT_DONE(driver_.click("compare.1.remove"));
    driver_.frames(2);
    EXPECT_EQ(state("kept states"), "1");
}

TEST_F(Reading, a_profile_runs_along_the_line_that_was_drawn) {
    ASSERT_TRUE(driver_.wait_settled());
    EXPECT_DONE(driver_.press("L"));
    driver_.frames(2);
    const ScreenRect view = *driver_.workbench().widgets().find("view");
    driver_.point_at(view.x() - 60.0F, view.y() + 20.0F);
    driver_.button(0, true);
    driver_.frames(2);
    driver_.point_at(view.x() + 60.0F, view.y() + 20.0F);
    driver_.frames(2);
    driver_.button(0, false);
    driver_.frames(3);
    const ProfilePanel& profile = driver_.workbench().readings().profile;
    ASSERT_TRUE(profile.line());
    EXPECT_GT(profile.line()->length(), 0.1);
    ASSERT_TRUE(driver_.wait_until([&] { return profile.sampler() && profile.sampler()->done(); }));
    EXPECT_GE(profile.sampler()->samples().size(), 97U);
    EXPECT_EQ(state("undo depth"), "0");
}

TEST_F(Reading, every_tab_of_reading_is_drawn_with_its_plot) {
    ASSERT_TRUE(driver_.wait_settled());
    EXPECT_DONE(driver_.click("menu.Results"));
    EXPECT_DONE(driver_.click("results.histogram"));
    driver_.frames(3);
    EXPECT_TRUE(driver_.workbench().widgets().find("histogram.plot"));
    EXPECT_DONE(driver_.press("V"));
    driver_.frames(2);
    EXPECT_TRUE(driver_.workbench().viewport().state.options.values);
}

}  // namespace
}  // namespace hanei
