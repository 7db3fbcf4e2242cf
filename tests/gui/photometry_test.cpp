#include "app/desktop.h"
#include "engine/edit/edit.h"
#include "engine/edit/luminaire_edits.h"
#include "engine/report/photometry_figures.h"
#include "ui/panels/state_text.h"
#include "ui/window/driver.h"

#include <fstream>
#include <gtest/gtest.h>

namespace hanei {
namespace {

#define EXPECT_DONE(action) EXPECT_EQ(action, "")

std::filesystem::path measured(const std::string& name) {
    return std::filesystem::path(HANEI_SOURCE) / "assets/photometry" / name;
}

/// An empty room with one luminaire of this file, chosen, its photometry shown.
class ThePhotometryPanel : public testing::Test {
protected:
    ThePhotometryPanel() : driver({content("wall-washer.ies"), {}, project_door()}) {
        EXPECT_DONE(driver.click("tree.Washer"));
        EXPECT_DONE(driver.click("tab.Photometry"));
    }

    static ProjectContent content(const std::string& file) {
        Photometry photometry = project_door().read_luminaires(measured(file)).content->front();
        Added added = with_measured_luminaire(empty_room(), std::move(photometry));
        added.scene.luminaires.front().name = "Washer";
        return {std::move(added.scene), {}};
    }

    std::string state(const std::string& name) { return state_of(driver.workbench())[name]; }
    const SceneSnapshot& scene() const { return driver.workbench().document().shown(); }
    const Photometry& photometry() const { return *photometry_of(*scene(), scene()->luminaires.front()); }

    /// The step is undone to the same scene and made again.
    void expect_step(const SceneSnapshot& before, const std::string& name) {
        EXPECT_EQ(state("undo"), name);
        const Scene after = *scene();
        EXPECT_NE(after, *before);
        EXPECT_DONE(driver.press("Ctrl+Z"));
        EXPECT_EQ(scene(), before);
        EXPECT_DONE(driver.press("Ctrl+Y"));
        EXPECT_EQ(*scene(), after);
    }

    Driver driver;
};

TEST_F(ThePhotometryPanel, reads_the_intensity_under_the_pointer) {
    EXPECT_EQ(state("readout"), "");
    const ScreenRect plot = *driver.workbench().widgets().find("photometry.plot");
    driver.point_at(plot.x() + 40.0F, plot.y());
    EXPECT_NE(state("readout").find("C0  "), std::string::npos) << state("readout");
    EXPECT_NE(state("readout").find("C90  "), std::string::npos);
    driver.point_at(plot.x() - 40.0F, plot.y());
    EXPECT_NE(state("readout").find("C180  "), std::string::npos) << state("readout");
    EXPECT_DONE(driver.click("photometry.cartesian"));
    EXPECT_DONE(driver.click("photometry.klm"));
    EXPECT_DONE(driver.point_at("photometry.plot"));
    EXPECT_NE(state("readout").find("cd/klm"), std::string::npos) << state("readout");
    EXPECT_EQ(state("undo depth"), "0");
}

TEST_F(ThePhotometryPanel, shows_the_plane_that_is_chosen) {
    EXPECT_DONE(driver.click("photometry.plane"));
    EXPECT_DONE(driver.click("photometry.plane.30"));
    EXPECT_DONE(driver.point_at("photometry.plot"));
    EXPECT_NE(state("readout").find("30  "), std::string::npos) << state("readout");
}

TEST_F(ThePhotometryPanel, turns_the_intensities_and_the_luminaire_apart) {
    const SceneSnapshot before = scene();
    const PhotometryFigures figures = photometry_figures(photometry());
    EXPECT_DONE(driver.click("photometry.turn"));
    EXPECT_EQ(state("quarter turns"), "1");
    EXPECT_EQ(state("yaw"), "0.000000");
    EXPECT_EQ(photometry_figures(photometry()).plane_0.peak.value, figures.plane_0.peak.value);
    expect_step(before, "Turn intensities by 90 degrees");
    const SceneSnapshot turned = scene();
    EXPECT_DONE(driver.click("luminaire.turn"));
    EXPECT_EQ(state("quarter turns"), "1");
    EXPECT_EQ(state("yaw"), "90.000000");
    expect_step(turned, "Turn luminaire by 90 degrees");
    EXPECT_DONE(driver.press("Shift+T"));
    EXPECT_EQ(state("quarter turns"), "2");
    EXPECT_DONE(driver.press("T"));
    EXPECT_EQ(state("yaw"), "180.000000");
}

TEST_F(ThePhotometryPanel, sets_the_flux_and_takes_it_as_measured_again) {
    const SceneSnapshot before = scene();
    EXPECT_EQ(state("flux"), "as measured");
    EXPECT_DONE(driver.click("luminaire.flux"));
    driver.type("3000");
    EXPECT_DONE(driver.press("Enter"));
    EXPECT_EQ(state("flux"), "3000");
    expect_step(before, "Set luminous flux");
    EXPECT_DONE(driver.click("luminaire.as_measured"));
    EXPECT_EQ(state("undo"), "Use flux as measured");
    EXPECT_EQ(*scene(), *before);
}

TEST_F(ThePhotometryPanel, takes_another_file_in_one_step) {
    const SceneSnapshot before = scene();
    EXPECT_DONE(driver.click("photometry.replace"));
    driver.type(measured("downlight.ies").string());
    EXPECT_DONE(driver.press("Enter"));
    EXPECT_EQ(state("photometry"), "Downlight 150");
    EXPECT_EQ(state("photometries"), "1");
    EXPECT_EQ(state("luminaires"), "1");
    expect_step(before, "Use another luminaire file");
}

TEST_F(ThePhotometryPanel, fits_the_side_of_small_and_dense_screens) {
    for (const float scale : {1.0F, 2.0F}) {
        Driver::Setup dense{content("linear-pendant.ies"), {}, project_door()};
        dense.size = {static_cast<int>(1280 * scale), static_cast<int>(800 * scale)};
        dense.scale = scale;
        Driver other(std::move(dense));
        EXPECT_DONE(other.click("tree.Washer"));
        EXPECT_DONE(other.click("tab.Photometry"));
        for (const char* name : {"photometry.plot", "photometry.klm", "photometry.other", "luminaire.flux"}) {
            const ScreenRect* rect = other.workbench().widgets().find(name);
            ASSERT_NE(rect, nullptr) << name;
            EXPECT_LE(rect->right, 1280.0F * scale) << name;
            EXPECT_GE(rect->left, (1280.0F - Preferences().right_width) * scale) << name;
            EXPECT_LE(rect->bottom, 800.0F * scale) << name;
        }
    }
}

/// A EULUMDAT file with two lamp sets: half and full light.
TEST(ALampSet, is_chosen_among_those_of_the_file_and_scales_the_light) {
    Photometry photometry = project_door().read_luminaires(measured("downlight.ies")).content->front();
    photometry.lamp_sets = {{1.0, "LED", 2000.0, "4000 K", "1B", 17.0},
                            {1.0, "LED, high output", 3000.0, "", "", 27.0}};
    Added added = with_measured_luminaire(empty_room(), photometry);
    added.scene.luminaires.front().name = "Spot";
    Driver driver({{std::move(added.scene), {}}, {}, project_door()});
    const auto shown = [&]() -> const Photometry& {
        const Scene& scene = *driver.workbench().document().shown();
        return *photometry_of(scene, scene.luminaires.front());
    };
    const SceneSnapshot before = driver.workbench().document().shown();
    EXPECT_DONE(driver.click("tree.Spot"));
    EXPECT_DONE(driver.click("tab.Photometry"));
    EXPECT_DONE(driver.click("photometry.lamps"));
    EXPECT_DONE(driver.click("photometry.lamps.LED, high output, 3000 lm, 27 W"));
    EXPECT_EQ(state_of(driver.workbench())["lamp set"], "1");
    EXPECT_EQ(state_of(driver.workbench())["undo"], "Choose lamp set");
    EXPECT_DOUBLE_EQ(shown().candela.front(), 1.5 * photometry.candela.front());
    EXPECT_EQ(shown().input_watts, 27.0);
    EXPECT_DONE(driver.press("Ctrl+Z"));
    EXPECT_EQ(driver.workbench().document().shown(), before);
}

}  // namespace
}  // namespace hanei
