#include "engine/scene/colour.h"

#include "app/desktop.h"
#include "engine/edit/edit.h"
#include "ui/panels/state_text.h"
#include "ui/window/driver.h"

#include <gtest/gtest.h>

namespace hanei {
namespace {

#define EXPECT_DONE(action) EXPECT_EQ(action, "")

/// The room with one red wall, a material or luminaire of it chosen in the list.
class TheColours : public testing::Test {
protected:
    TheColours() : driver(setup()) {}

    static Driver::Setup setup() {
        Opened<ProjectContent> opened =
            project_door().open(std::filesystem::path(HANEI_SOURCE) / "assets/rooms/painted-room.hanei");
        EXPECT_TRUE(opened.content);
        opened.content->settings.max_patch = 1.5;  // the window is on trial here, not the figures
        return {*opened.content, {}, project_door()};
    }

    std::string state(const std::string& name) { return state_of(driver.workbench())[name]; }
    const SceneSnapshot& scene() const { return driver.workbench().document().shown(); }
    const Material& material(const std::string& name) const {
        for (const Material& each : scene()->materials)
            if (each.name == name) return each;
        ADD_FAILURE() << name;
        return scene()->materials.front();
    }

    Driver driver;
};

TEST_F(TheColours, of_a_material_are_picked_in_one_step_that_undo_takes_back) {
    EXPECT_DONE(driver.click("tree.white"));
    const SceneSnapshot before = scene();
    EXPECT_DONE(driver.click("material.colour"));
    driver.frames(3);
    EXPECT_DONE(driver.drag("material.colour.picker", 20.0F, 30.0F));
    EXPECT_NE(material("white").tint, Vec3(1.0));
    EXPECT_EQ(material("white").reflectance, 0.8);
    EXPECT_EQ(state("undo depth"), "1");
    EXPECT_DONE(driver.press("Esc"));
    EXPECT_DONE(driver.press("Ctrl+Z"));
    EXPECT_EQ(scene(), before);
}

TEST_F(TheColours, of_a_material_are_typed_and_made_neutral_again) {
    EXPECT_DONE(driver.click("tree.white"));
    EXPECT_DONE(driver.click("material.colour.digits"));
    driver.type("F0E0D0");
    EXPECT_DONE(driver.press("Enter"));
    EXPECT_EQ(material("white").tint, tint_from_srgb(Vec3(0xF0, 0xE0, 0xD0) / 255.0, 0.8));
    EXPECT_DONE(driver.click("material.neutral"));
    EXPECT_EQ(material("white").tint, Vec3(1.0));
    EXPECT_EQ(state("undo depth"), "2");
}

TEST_F(TheColours, of_a_luminaire_are_chosen_and_undone) {
    EXPECT_DONE(driver.click("tree.Ceiling panel"));
    const SceneSnapshot before = scene();
    EXPECT_DONE(driver.click("luminaire.colour"));
    driver.frames(3);
    EXPECT_DONE(driver.click("luminaire.colour.3000 K"));
    EXPECT_EQ(scene()->luminaires.front().colour_temperature, 3000.0);
    EXPECT_EQ(state("undo"), "Change luminaire");
    EXPECT_DONE(driver.press("Ctrl+Z"));
    EXPECT_EQ(scene(), before);
}

TEST_F(TheColours, keep_every_widget_of_the_picker_on_the_screen) {
    EXPECT_DONE(driver.click("tree.paint, red"));
    EXPECT_DONE(driver.click("material.colour"));
    driver.frames(3);
    const ScreenRect* const picker = driver.workbench().widgets().find("material.colour.picker");
    const ScreenRect* const digits = driver.workbench().widgets().find("material.colour.digits");
    ASSERT_TRUE(picker != nullptr && digits != nullptr);
    EXPECT_GE(picker->left, 0.0F);
    EXPECT_LE(picker->right, digits->right + 1.0F);
    EXPECT_GE(picker->top, digits->bottom) << "the colour stays in sight";
}

}  // namespace
}  // namespace hanei
