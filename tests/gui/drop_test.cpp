#include "app/desktop.h"
#include "engine/edit/edit.h"
#include "engine/edit/luminaire_edits.h"
#include "engine/scene/intensity.h"
#include "ui/panels/state_text.h"
#include "ui/window/driver.h"
#include "ui/window/script.h"

#include <fstream>
#include <gtest/gtest.h>
#include <sstream>

namespace hanei {
namespace {

#define EXPECT_DONE(action) EXPECT_EQ(action, "")

std::filesystem::path measured(const std::string& name) {
    return std::filesystem::path(HANEI_SOURCE) / "assets/photometry" / name;
}

std::filesystem::path golden(const std::string& name) {
    return std::filesystem::path(HANEI_SOURCE) / "tests/golden/luminaires" / name;
}

/// An empty room of 6 m x 4 m with one panel hung in the middle.
class FilesDropped : public testing::Test {
protected:
    FilesDropped() : driver({content(), {}, project_door()}), before(scene()) {
        const ScreenRect view = *driver.workbench().widgets().find("view");
        x = view.x();
        y = view.y();
    }
    static ProjectContent content() { return {with_panel_luminaire(empty_room()).scene, {}}; }

    std::string state(const std::string& name) { return state_of(driver.workbench())[name]; }
    double figure(const std::string& name) { return std::stod(state(name)); }
    const SceneSnapshot& scene() const { return driver.workbench().document().shown(); }
    void drop(const std::filesystem::path& file) { driver.drop({file}, x, y); }

    void expect_one_step(const std::string& name) {
        EXPECT_EQ(state("undo depth"), "1");
        EXPECT_EQ(state("undo"), name);
        const Scene after = *scene();
        EXPECT_DONE(driver.press("Ctrl+Z"));
        EXPECT_EQ(scene(), before);
        EXPECT_DONE(driver.press("Ctrl+Y"));
        EXPECT_EQ(*scene(), after);
    }

    Driver driver;
    SceneSnapshot before;
    float x = 0.0F, y = 0.0F;
};

TEST_F(FilesDropped, hang_below_the_ceiling_over_the_place_they_are_dropped_on) {
    EXPECT_DONE(driver.press("P"));
    const auto floor = driver.workbench().viewport().on_screen({4.62, 1.28, 0.0});
    ASSERT_TRUE(floor);
    driver.drop({measured("downlight.ies")}, floor->x, floor->y);
    EXPECT_EQ(state("luminaires"), "2");
    EXPECT_EQ(state("selected"), "Downlight 150 2");
    EXPECT_EQ(state("message"), "Hung Downlight 150");
    EXPECT_NEAR(figure("selected.x"), 4.6, 1e-12);  // the raster of 0.1 m
    EXPECT_NEAR(figure("selected.y"), 1.3, 1e-12);
    EXPECT_NEAR(figure("selected.z"), 2.75, 1e-12);
    expect_one_step("Add luminaire from file");
}

TEST_F(FilesDropped, hang_side_by_side_when_they_are_several) {
    driver.drop({measured("downlight.ies"), measured("linear-pendant.ies"), measured("downlight.ies")}, x, y);
    EXPECT_EQ(state("luminaires"), "4");
    EXPECT_EQ(state("photometries"), "2");  // the same file is kept once
    EXPECT_EQ(state("message"), "Hung 3 luminaires");
    const auto& hung = scene()->luminaires;
    EXPECT_NEAR(hung[2].position.x - hung[1].position.x, 0.5 * (0.15 + 1.48) + 0.3, 1e-9);
    EXPECT_EQ(hung[1].position.y, hung[3].position.y);
    expect_one_step("Add luminaires from files");
}

TEST_F(FilesDropped, change_nothing_when_they_are_broken) {
    const auto file = std::filesystem::path(testing::TempDir()) / "broken.ies";
    std::ofstream(file) << "IESNA:LM-63-2002\nTILT=NONE\n1 1000 1 3 1 1 2 0.2 0.2 0\n1 1 10\n0 45 90\n0\n300 200\n";
    drop(file);
    EXPECT_EQ(scene(), before);
    EXPECT_EQ(state("undo depth"), "0");
    EXPECT_EQ(state("message"), "broken.ies cannot be used");
    EXPECT_EQ(state("dialog"), "findings");
    EXPECT_NE(state("finding"), "");
    drop(measured("downlight.ies"));
    EXPECT_EQ(scene(), before);  // the dialog wants an answer first
    EXPECT_DONE(driver.click("findings.ok"));
    drop("/nowhere/at all.ldt");
    EXPECT_EQ(scene(), before);
}

TEST_F(FilesDropped, ask_which_luminaire_of_a_container) {
    drop(golden("containers/two_emitters_bom.gldf"));
    EXPECT_EQ(state("dialog"), "choice");
    EXPECT_EQ(scene(), before);
    EXPECT_DONE(driver.click("choice.2"));
    EXPECT_EQ(state("dialog"), "none");
    EXPECT_EQ(state("luminaires"), "2");
    expect_one_step("Add luminaire from file");
    drop(golden("containers/two_emitters_bom.gldf"));
    EXPECT_DONE(driver.click("choice.cancel"));
    EXPECT_EQ(state("luminaires"), "2");
    drop(golden("containers/two_emitters_bom.gldf"));
    EXPECT_DONE(driver.click("choice.3"));
    EXPECT_EQ(state("luminaires"), "4");  // all of them
}

TEST_F(FilesDropped, on_the_chosen_luminaire_may_give_it_their_light) {
    EXPECT_DONE(driver.click("tree.Panel 1"));
    EXPECT_DONE(driver.drop_on_object({measured("downlight.ies")}, "Panel 1"));
    EXPECT_EQ(state("dialog"), "choice");
    EXPECT_DONE(driver.click("choice.1"));
    EXPECT_EQ(state("luminaires"), "1");
    EXPECT_EQ(state("photometry"), "Downlight 150");
    EXPECT_EQ(state("message"), "Panel 1 shines as Downlight 150");
    expect_one_step("Use another luminaire file");
    const ScreenRect* field = driver.workbench().widgets().find("luminaire.z");
    ASSERT_NE(field, nullptr);
    driver.drop({measured("wall-washer.ies")}, field->x(), field->y());  // beside the view
    EXPECT_EQ(state("photometry"), "Wall washer 300, asymmetric");
    EXPECT_EQ(state("photometries"), "1");
}

TEST_F(FilesDropped, open_when_they_are_projects_and_ask_about_unsaved_changes) {
    drop(measured("downlight.ies"));
    const auto file = std::filesystem::path(testing::TempDir()) / "dropped.hanei";
    ASSERT_FALSE(project_door().save(content(), file));
    drop(file);
    EXPECT_EQ(state("dialog"), "unsaved");
    EXPECT_DONE(driver.click("unsaved.discard"));
    EXPECT_EQ(state("message"), "Opened dropped.hanei");
    EXPECT_EQ(state("luminaires"), "1");
}

TEST_F(FilesDropped, are_played_by_scripts) {
    const std::string file = measured("downlight.ies").string();
    std::ostringstream out;
    const std::string script = "drop \"" + file + "\" 500 300\nexpect luminaires 2\nclick \"tree.Panel 1\"\n" +
                               "drop \"" + file + "\" object \"Panel 1\"\nclick choice.2\nexpect luminaires 3\n";
    const auto fault = play_script(script, "drop.script", driver, out);
    EXPECT_FALSE(fault) << to_text(*fault);
    const auto wrong = play_script("drop a.ies 500 here\n", "wrong.script", driver, out);
    ASSERT_TRUE(wrong);
    EXPECT_EQ(wrong->message, "drop wants FILE... X Y, or FILE... object NAME");
}

/// Where the mark of a plane stands, from the luminaire, on the screen.
TEST_F(FilesDropped, show_their_planes_which_turn_with_the_intensities) {
    EXPECT_DONE(driver.press("P"));
    drop(measured("wall-washer.ies"));
    const auto mark = [&](const char* name) {
        const ScreenRect* rect = driver.workbench().widgets().find(name);
        const ImVec2 middle = *driver.workbench().viewport().on_screen(scene()->luminaires.back().position);
        return rect == nullptr ? ImVec2{} : ImVec2{rect->x() - middle.x, rect->y() - middle.y};
    };
    EXPECT_GT(mark("plane.C0").x, 20.0F);
    EXPECT_NEAR(mark("plane.C0").y, 0.0F, 1.0F);
    EXPECT_LT(mark("plane.C90").y, -20.0F);
    EXPECT_DONE(driver.press("Shift+T"));
    EXPECT_LT(mark("plane.C0").y, -20.0F);
    EXPECT_LT(mark("plane.C90").x, -20.0F);
    EXPECT_DONE(driver.press("T"));
    EXPECT_LT(mark("plane.C0").x, -20.0F);
}

}  // namespace
}  // namespace hanei
