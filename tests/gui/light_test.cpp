/// Groups, light scenes, arrangements and aiming by real events.
#include "app/desktop.h"
#include "engine/edit/aiming.h"
#include "engine/edit/arrangements.h"
#include "engine/edit/control_groups.h"
#include "tests/unit/edit/luminaire_scenes.h"
#include "ui/panels/state_text.h"
#include "ui/window/driver.h"

#include <gtest/gtest.h>

namespace hanei {
namespace {

#define EXPECT_DONE(action) EXPECT_EQ(action, "")

/// The empty room with a field of 2 x 2 luminaires, the first row in "Window", the second in "Wall".
ProjectContent lit_room() {
    Added lamp = test::hung(test::lobe(1.0));
    Added field = arranged(lamp.scene, lamp.object, field_over_room(lamp.scene, 2.7, 2, 2));
    Scene scene = std::move(field.scene);
    for (std::size_t row = 0; row < 2; ++row) {
        const ObjectId group = control_group_named(scene, row == 0 ? "Window" : "Wall");
        const auto& members = scene.arrangements[0].luminaires;
        const std::vector<ObjectId> two{members[2 * row], members[2 * row + 1]};
        scene = with_group_of(std::move(scene), two, group);
    }
    ProjectContent content{with_grid(std::move(scene)).scene, {}};
    content.settings.max_patch = 1.5;  // the window is on trial here, not the figures
    return content;
}

class TheLightTab : public testing::Test {
protected:
    void SetUp() override {
        ASSERT_TRUE(driver_.wait_settled());
        EXPECT_DONE(driver_.click("tab.Light"));
    }
    const Scene& scene() const { return *driver_.workbench().document().shown(); }
    std::string state(const std::string& name) const { return state_of(driver_.workbench())[name]; }
    double level(const char* group) const {
        for (const ControlGroup& each : scene().control_groups)
            if (each.name == group) return each.dimming;
        return -1.0;
    }

    Driver driver_{Driver::Setup{lit_room(), {}, project_door()}};
};

TEST_F(TheLightTab, dims_a_group_by_its_slider_in_one_step) {
    EXPECT_DONE(driver_.drag("light.dimmer.Window", -60.0F, 0.0F));
    EXPECT_LT(level("Window"), 0.6);
    EXPECT_GT(level("Window"), 0.0);
    EXPECT_EQ(level("Wall"), 1.0);
    EXPECT_EQ(state("undo depth"), "1");
    EXPECT_EQ(state("undo"), "Dim Window");
    EXPECT_DONE(driver_.press("Ctrl+Z"));
    EXPECT_EQ(level("Window"), 1.0);
}

TEST_F(TheLightTab, keeps_a_light_scene_and_switches_back_to_it_by_button_and_by_key) {
    EXPECT_DONE(driver_.click("light.keep"));
    ASSERT_EQ(scene().light_scenes.size(), 1U);
    EXPECT_DONE(driver_.click("light.off.Wall"));
    EXPECT_EQ(level("Wall"), 0.0);
    EXPECT_DONE(driver_.click("light.keep"));
    ASSERT_EQ(scene().light_scenes.size(), 2U);
    EXPECT_DONE(driver_.click("light.scene.Light scene 1"));
    EXPECT_EQ(level("Wall"), 1.0);
    EXPECT_EQ(state("undo"), "Switch to Light scene 1");
    EXPECT_DONE(driver_.press("Ctrl+F2"));
    EXPECT_EQ(level("Wall"), 0.0);
    EXPECT_TRUE(driver_.wait_settled());
    EXPECT_EQ(state("fresh"), "true");
}

TEST_F(TheLightTab, shows_one_group_alone_and_then_all_as_they_were) {
    EXPECT_DONE(driver_.drag("light.dimmer.Wall", -40.0F, 0.0F));
    const double before = level("Wall");
    EXPECT_DONE(driver_.click("light.alone.Window"));
    EXPECT_EQ(level("Wall"), 0.0);
    EXPECT_EQ(level("Window"), 1.0);
    EXPECT_DONE(driver_.click("light.alone.Wall"));
    EXPECT_EQ(level("Window"), 0.0);
    EXPECT_DONE(driver_.click("light.alone.Wall"));
    EXPECT_EQ(level("Window"), 1.0);
    EXPECT_EQ(level("Wall"), before);
}

TEST_F(TheLightTab, switches_a_group_off_and_on_again_as_it_was) {
    EXPECT_DONE(driver_.drag("light.dimmer.Wall", -40.0F, 0.0F));
    const double before = level("Wall");
    EXPECT_DONE(driver_.click("light.off.Wall"));
    EXPECT_EQ(level("Wall"), 0.0);
    EXPECT_DONE(driver_.click("light.off.Wall"));
    EXPECT_EQ(level("Wall"), before);
}

TEST_F(TheLightTab, makes_a_group_of_the_selection_and_shows_its_panel) {
    EXPECT_DONE(driver_.click("tree." + scene().arrangements[0].name));
    EXPECT_DONE(driver_.click("light.new_group"));
    ASSERT_EQ(scene().control_groups.size(), 3U);
    EXPECT_EQ(members_of(scene(), scene().control_groups[2].id), 4);
    EXPECT_DONE(driver_.click("light.group.Group 3"));
    EXPECT_DONE(driver_.click("tab.Properties"));
    EXPECT_DONE(driver_.click("group.dimming"));
    driver_.type("25");
    EXPECT_DONE(driver_.press("Enter"));
    EXPECT_EQ(level("Group 3"), 0.25);
}

TEST(Arrangements, are_changed_in_their_panel_and_let_go_of_a_dragged_luminaire) {
    Driver driver(Driver::Setup{lit_room(), {}, project_door()});
    ASSERT_TRUE(driver.wait_settled());
    const auto scene = [&]() -> const Scene& { return *driver.workbench().document().shown(); };
    EXPECT_DONE(driver.click("tree." + scene().arrangements[0].name));
    EXPECT_DONE(driver.click("arrangement.columns"));
    driver.type("3");
    EXPECT_DONE(driver.press("Enter"));
    EXPECT_EQ(scene().luminaires.size(), 6U);
    const std::string first = scene().luminaires.front().name;
    EXPECT_DONE(driver.click("tree." + first));
    EXPECT_DONE(driver.press("Right"));
    EXPECT_EQ(luminaires_in(scene().arrangements[0]), 5U);
    EXPECT_DONE(driver.press("Ctrl+Z"));
    EXPECT_EQ(luminaires_in(scene().arrangements[0]), 6U);
}

TEST(Aiming, by_a_click_in_the_view_turns_the_selected_luminaire_in_one_step) {
    Driver driver(Driver::Setup{lit_room(), {}, project_door()});
    ASSERT_TRUE(driver.wait_settled());
    const SceneSnapshot before = driver.workbench().document().shown();
    EXPECT_DONE(driver.click("tree." + before->luminaires.front().name));
    EXPECT_DONE(driver.press("A"));
    ASSERT_NE(driver.workbench().viewport().tool(), nullptr);
    EXPECT_DONE(driver.click("view"));
    EXPECT_EQ(driver.workbench().viewport().tool(), nullptr) << "it lays itself down";
    const Luminaire& turned = driver.workbench().document().shown()->luminaires.front();
    EXPECT_NE(turned.tilt, 0.0);
    EXPECT_EQ(turned.position, before->luminaires.front().position);
    EXPECT_EQ(state_of(driver.workbench())["undo"], "Aim luminaire");
    EXPECT_EQ(state_of(driver.workbench())["undo depth"], "1");
}

TEST(StartLayout, is_hung_from_the_dialog_and_compared_with_the_solution) {
    Driver driver(Driver::Setup{{test::hung(test::lobe(1.0)).scene, {}}, {}, project_door()});
    ASSERT_TRUE(driver.wait_settled());
    EXPECT_DONE(driver.click("menu.Light"));
    EXPECT_DONE(driver.click("light.layout"));
    EXPECT_DONE(driver.click("layout.target"));
    driver.type("300");
    EXPECT_DONE(driver.press("Enter"));
    EXPECT_DONE(driver.click("layout.hang"));
    const Scene& scene = *driver.workbench().document().shown();
    ASSERT_EQ(scene.arrangements.size(), 1U);
    EXPECT_GT(scene.luminaires.size(), 2U);
    ASSERT_TRUE(driver.wait_settled());
    const SolutionSnapshot answer = driver.workbench().study().answer();
    ASSERT_EQ(answer->grids.size(), 1U);
    const double mean = figures_of(answer->grids[0]).mean;
    constexpr double as_the_lumen_method_foretells = 0.1;
    EXPECT_GT(mean, (1.0 - as_the_lumen_method_foretells) * 300.0);
    EXPECT_DONE(driver.click("tab.Light"));
    EXPECT_DONE(driver.click("layout.dim"));
    ASSERT_TRUE(driver.wait_settled());
    constexpr double rounding = 0.01;
    EXPECT_NEAR(figures_of(driver.workbench().study().answer()->grids[0]).mean, 300.0, rounding * 300.0);
}

TEST(StartLayout, comes_back_with_the_figures_it_was_asked_with) {
    Driver driver(Driver::Setup{{test::hung(test::lobe(1.0)).scene, {}}, {}, project_door()});
    const auto ask = [&] {
        EXPECT_DONE(driver.click("menu.Light"));
        EXPECT_DONE(driver.click("light.layout"));
    };
    const auto type = [&](const char* field, const char* figure) {
        EXPECT_DONE(driver.click(field));
        driver.type(figure);
        EXPECT_DONE(driver.press("Enter"));
    };
    ask();
    EXPECT_DONE(driver.click("layout.by_hand"));
    type("layout.columns", "4");
    type("layout.rows", "3");
    EXPECT_DONE(driver.click("layout.cancel"));
    ask();
    EXPECT_NE(driver.workbench().widgets().find("layout.columns"), nullptr) << "still by hand";
    EXPECT_DONE(driver.click("layout.hang"));
    ASSERT_EQ(driver.workbench().document().shown()->luminaires.size(), 12U);
    driver.workbench().choose(driver.workbench().document().shown()->luminaires.back().id);
    ask();
    ASSERT_NE(driver.workbench().widgets().find("layout.columns"), nullptr) << "another one of the field";
    type("layout.rows", "2");
    EXPECT_DONE(driver.click("layout.hang"));
    EXPECT_EQ(driver.workbench().document().shown()->luminaires.size(), 8U);
}

}  // namespace
}  // namespace hanei
