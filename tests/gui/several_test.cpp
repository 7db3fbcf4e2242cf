#include "engine/edit/several.h"

#include "computer_room.h"
#include "ui/panels/state_text.h"
#include "ui/window/driver.h"

#include <gtest/gtest.h>

namespace hanei {
namespace {

std::string state(const Driver& driver, const std::string& name) { return state_of(driver.workbench())[name]; }

#define EXPECT_DONE(action) EXPECT_EQ(action, "")

TEST(ManyObjects, are_changed_together_by_one_field_in_one_step) {
    Driver driver(computer_room());
    const SceneSnapshot before = driver.workbench().document().shown();
    EXPECT_DONE(driver.click("tree.Ceiling panel 1"));
    EXPECT_DONE(driver.press("Ctrl+Shift+A"));
    EXPECT_DONE(driver.click("luminaire.x"));
    driver.type("1.5+0.25");
    EXPECT_DONE(driver.press("Enter"));
    const Scene& scene = *driver.workbench().document().shown();
    for (const Luminaire& luminaire : scene.luminaires) EXPECT_EQ(luminaire.position.x, 1.75);
    EXPECT_EQ(scene.luminaires[0].position.z, before->luminaires[0].position.z);
    EXPECT_EQ(state(driver, "undo depth"), "1");
    EXPECT_EQ(state(driver, "undo"), "Change 2 luminaires");
    EXPECT_DONE(driver.press("Ctrl+Z"));
    EXPECT_EQ(*driver.workbench().document().shown(), *before);
}

TEST(ManyObjects, that_differ_take_the_value_of_the_last_one_when_it_is_typed) {
    Driver driver(computer_room());
    EXPECT_DONE(driver.click("tree.Ceiling panel 1"));
    EXPECT_DONE(driver.click("luminaire.dimming"));
    driver.type("40");
    EXPECT_DONE(driver.press("Enter"));
    EXPECT_DONE(driver.press("Ctrl+Shift+A"));
    EXPECT_EQ(state(driver, "selected"), "Ceiling panel 2");
    EXPECT_DONE(driver.click("luminaire.dimming"));
    driver.type("100");
    EXPECT_DONE(driver.press("Enter"));
    for (const Luminaire& luminaire : driver.workbench().document().shown()->luminaires)
        EXPECT_EQ(luminaire.dimming, 1.0);
}

TEST(ManyObjects, are_numbered_when_they_are_named_together) {
    Driver driver(computer_room());
    EXPECT_DONE(driver.click("tree.Ceiling panel 1"));
    EXPECT_DONE(driver.press("Ctrl+Shift+A"));
    EXPECT_DONE(driver.click("luminaire.name"));
    driver.type("Row");
    EXPECT_DONE(driver.press("Enter"));
    const Scene& scene = *driver.workbench().document().shown();
    EXPECT_EQ(scene.luminaires[0].name, "Row 2");
    EXPECT_EQ(scene.luminaires[1].name, "Row");
}

}  // namespace
}  // namespace hanei
