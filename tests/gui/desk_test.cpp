#include "app/desktop.h"
#include "engine/edit/edit.h"
#include "ui/panels/state_text.h"
#include "ui/window/driver.h"
#include "ui/window/script.h"

#include <fstream>
#include <gtest/gtest.h>
#include <sstream>

namespace hanei {
namespace {

const std::string desk_point = "point Desk A, beside the terminal";
const std::string panel = "Ceiling panel 1";

std::filesystem::path room_file() {
    return std::filesystem::path(HANEI_SOURCE) / "assets/rooms/computer-room-panels.hanei";
}

std::filesystem::path scratch(const std::string& name) {
    const std::filesystem::path folder = std::filesystem::path(testing::TempDir()) / "hanei gui";
    std::filesystem::create_directories(folder);
    return folder / name;
}

/// The computer room with wide patches: the window is on trial here, not the figures.
ProjectContent room() {
    Opened<ProjectContent> opened = project_door().open(room_file());
    EXPECT_TRUE(opened.content);
    opened.content->settings.max_patch = 1.5;
    return *opened.content;
}

Driver::Setup setup(const std::filesystem::path& file = scratch("room.hanei")) {
    return {room(), file, project_door()};
}

std::string state(const Driver& driver, const std::string& name) { return state_of(driver.workbench())[name]; }
double figure(const Driver& driver, const std::string& name) { return std::stod(state(driver, name)); }

#define EXPECT_DONE(action) EXPECT_EQ(action, "")

TEST(TheDesk, shows_another_illuminance_after_a_luminaire_was_dragged_and_the_same_after_undo) {
    Driver driver(setup());
    ASSERT_TRUE(driver.wait_settled());
    const SceneSnapshot before = driver.workbench().document().shown();
    const double lux_before = figure(driver, desk_point);
    const double x_before = place_of(*before, object_named(*before, panel))->x;
    EXPECT_DONE(driver.drag_object(panel, {0.8, 0.0, 0.0}));
    ASSERT_TRUE(driver.wait_settled());
    EXPECT_NEAR(figure(driver, "selected.x"), x_before + 0.8, 0.051);  // half a step of the 0.1 m raster
    EXPECT_GT(std::abs(figure(driver, desk_point) - lux_before), 0.01 * lux_before);
    EXPECT_EQ(state(driver, "undo depth"), "1");
    EXPECT_EQ(state(driver, "undo"), "Move luminaire");
    EXPECT_DONE(driver.press("Ctrl+Z"));
    ASSERT_TRUE(driver.wait_settled());
    EXPECT_EQ(driver.workbench().document().shown(), before);
    EXPECT_EQ(figure(driver, desk_point), lux_before);  // the same bits
    EXPECT_EQ(state(driver, "saved"), "true");
}

TEST(TheDesk, raises_a_luminaire_by_its_arrow_and_leaves_its_plan_alone) {
    Driver driver(setup());
    ASSERT_TRUE(driver.wait_settled());
    EXPECT_DONE(driver.click_object(panel));
    const double x = figure(driver, "selected.x");
    const double z = figure(driver, "selected.z");
    EXPECT_DONE(driver.drag_object(panel, {0.0, 0.0, -0.6}));
    EXPECT_NEAR(figure(driver, "selected.z"), z - 0.6, 0.051);
    EXPECT_EQ(figure(driver, "selected.x"), x);
}

TEST(TheDesk, moves_furniture_and_nudges_it) {
    Driver driver(setup());
    ASSERT_TRUE(driver.wait_settled());
    EXPECT_DONE(driver.click("tree.Side table"));
    const double y = figure(driver, "selected.y");
    EXPECT_DONE(driver.press("Up"));
    EXPECT_NEAR(figure(driver, "selected.y"), y + 0.1, 1e-9);
    EXPECT_DONE(driver.press("Shift+Down"));
    EXPECT_NEAR(figure(driver, "selected.y"), y + 0.09, 1e-9);
    ASSERT_TRUE(driver.wait_settled());
    EXPECT_EQ(state(driver, "fresh"), "true");
}

TEST(TheDesk, takes_typed_figures_as_one_step) {
    Driver driver(setup());
    EXPECT_DONE(driver.click("tree." + panel));
    EXPECT_DONE(driver.click("luminaire.z"));
    driver.type("2.5");
    EXPECT_EQ(state(driver, "undo depth"), "0");
    EXPECT_DONE(driver.press("Enter"));
    EXPECT_EQ(figure(driver, "selected.z"), 2.5);
    EXPECT_EQ(state(driver, "undo depth"), "1");
    EXPECT_EQ(state(driver, "undo"), "Change luminaire");
}

TEST(TheDesk, keeps_a_typed_figure_when_another_object_is_chosen_with_the_next_click) {
    Driver driver(setup());
    EXPECT_DONE(driver.click("tree." + panel));
    EXPECT_DONE(driver.click("luminaire.x"));
    driver.type("3.3");
    EXPECT_DONE(driver.click("tree.Cooler"));
    EXPECT_EQ(state(driver, "selected"), "Cooler");
    const Scene& scene = *driver.workbench().document().shown();
    EXPECT_EQ(place_of(scene, object_named(scene, panel))->x, 3.3);
}

TEST(TheDesk, adds_copies_and_deletes) {
    Driver driver(setup());
    const auto before = *driver.workbench().document().shown();
    EXPECT_DONE(driver.click("menu.Add"));
    EXPECT_DONE(driver.click("add.panel"));
    EXPECT_EQ(state(driver, "luminaires"), "3");
    EXPECT_DONE(driver.press("Ctrl+D"));
    EXPECT_EQ(state(driver, "luminaires"), "4");
    EXPECT_DONE(driver.press("Delete"));
    EXPECT_EQ(state(driver, "luminaires"), "3");
    for (int k = 0; k < 3; ++k) EXPECT_DONE(driver.press("Ctrl+Z"));
    EXPECT_EQ(*driver.workbench().document().shown(), before);
    EXPECT_DONE(driver.press("Ctrl+Shift+Z"));
    EXPECT_EQ(state(driver, "luminaires"), "3");
}

TEST(TheDesk, reads_the_light_under_the_pointer) {
    Driver driver(setup());
    ASSERT_TRUE(driver.wait_settled());
    EXPECT_DONE(driver.press("P"));
    EXPECT_DONE(driver.point_at_object("Side table"));
    EXPECT_NE(state(driver, "probe").find("Side table"), std::string::npos) << state(driver, "probe");
    EXPECT_NE(state(driver, "probe").find("interreflected"), std::string::npos);
}

TEST(TheDesk, works_out_shadows_while_they_are_looked_at_and_follows_the_chosen_luminaire) {
    Driver driver(setup());
    ASSERT_TRUE(driver.wait_settled());
    EXPECT_EQ(driver.workbench().study().solution()->shadows, nullptr);
    EXPECT_DONE(driver.click("view.shadow_classes"));
    EXPECT_DONE(driver.press("O"));
    ASSERT_TRUE(driver.wait_settled());
    ASSERT_NE(driver.workbench().study().solution()->shadows, nullptr);
    EXPECT_EQ(state(driver, "shadow classes"), "true");
    EXPECT_EQ(state(driver, "shadow outlines"), "true");
    EXPECT_DONE(driver.click("tree." + panel));
    EXPECT_DONE(driver.press("2"));
    EXPECT_EQ(state(driver, "shadow classes"), "false");
    EXPECT_EQ(state(driver, "part"), "direct");
}

TEST(TheDesk, paints_an_exact_picture_while_the_room_is_edited_and_saves_it) {
    const auto file = scratch("exact.png");
    std::filesystem::remove(file);
    Driver driver(setup());
    ASSERT_TRUE(driver.wait_settled());
    EXPECT_DONE(driver.click("menu.File"));
    EXPECT_DONE(driver.click("file.render_exact"));
    EXPECT_EQ(state(driver, "exact"), "painting");
    EXPECT_DONE(driver.click("tree.Side table"));
    EXPECT_DONE(driver.press("Up"));
    EXPECT_EQ(state(driver, "undo depth"), "1");
    ASSERT_TRUE(driver.wait_until([&] { return state(driver, "exact") == "shown"; }));
    driver.frames(3);
    EXPECT_DONE(driver.click("exact.save"));
    driver.type("exact.png");
    EXPECT_DONE(driver.press("Enter"));
    driver.frames(2);
    EXPECT_TRUE(std::filesystem::exists(file)) << state(driver, "message");
    EXPECT_DONE(driver.click("exact.close"));
    EXPECT_EQ(state(driver, "exact"), "none");
}

TEST(TheDesk, stops_an_exact_picture_by_its_button) {
    Driver driver(setup());
    ASSERT_TRUE(driver.wait_settled());
    EXPECT_DONE(driver.press("Ctrl+R"));
    driver.frames(2);
    EXPECT_EQ(state(driver, "exact"), "painting");
    EXPECT_DONE(driver.click("exact.cancel"));
    EXPECT_EQ(state(driver, "exact"), "none");
    driver.frames(2);
    EXPECT_EQ(driver.workbench().widgets().find("exact.picture"), nullptr);
    EXPECT_EQ(driver.workbench().widgets().find("exact.progress"), nullptr);
}

TEST(TheDesk, saves_and_opens_what_was_changed) {
    const auto file = scratch("saved.hanei");
    std::filesystem::remove(file);
    Driver driver(setup(file));
    EXPECT_DONE(driver.click("tree." + panel));
    EXPECT_DONE(driver.press("Right"));
    EXPECT_EQ(state(driver, "saved"), "false");
    EXPECT_DONE(driver.press("Ctrl+S"));
    EXPECT_EQ(state(driver, "saved"), "true") << state(driver, "dialog");
    const auto opened = project_door().open(file);
    ASSERT_TRUE(opened.content);
    EXPECT_EQ(opened.content->scene, *driver.workbench().document().shown());
    EXPECT_DONE(driver.press("Ctrl+O"));
    EXPECT_EQ(state(driver, "browser"), "true");
    EXPECT_DONE(driver.click("file.saved.hanei"));
    EXPECT_DONE(driver.click("browser.accept"));
    EXPECT_EQ(state(driver, "message"), "Opened saved.hanei");
    EXPECT_EQ(state(driver, "undo depth"), "0");
}

TEST(TheDesk, asks_before_unsaved_changes_are_lost) {
    Driver driver(setup());
    EXPECT_DONE(driver.click("tree." + panel));
    EXPECT_DONE(driver.press("Right"));
    EXPECT_DONE(driver.press("Ctrl+Q"));
    EXPECT_EQ(state(driver, "dialog"), "unsaved");
    EXPECT_FALSE(driver.workbench().wants_to_quit());
    EXPECT_DONE(driver.click("unsaved.cancel"));
    EXPECT_EQ(state(driver, "dialog"), "none");
    EXPECT_FALSE(driver.workbench().wants_to_quit());
    EXPECT_DONE(driver.press("Ctrl+Q"));
    EXPECT_DONE(driver.click("unsaved.discard"));
    EXPECT_TRUE(driver.workbench().wants_to_quit());
}

TEST(TheDesk, adds_a_luminaire_from_a_file) {
    std::ofstream(scratch("round.ies")) << "IESNA:LM-63-2002\n[TEST] none\n[MANUFAC] house\nTILT=NONE\n"
                                           "1 1000 1 3 1 1 2 0.2 0.2 0\n1 1 10\n0 45 90\n0\n300 200 0\n";
    Driver driver(setup());
    EXPECT_DONE(driver.press("Ctrl+L"));
    EXPECT_DONE(driver.click("file.round.ies"));
    EXPECT_DONE(driver.press("Enter"));
    EXPECT_DONE(driver.click("browser.accept"));
    EXPECT_EQ(state(driver, "luminaires"), "3");
    ASSERT_TRUE(driver.wait_settled());
    EXPECT_EQ(state(driver, "fresh"), "true");
}

TEST(TheDesk, draws_the_same_picture_twice_bit_for_bit) {
    const auto picture = [] {
        Driver driver(setup());
        EXPECT_TRUE(driver.wait_settled());
        EXPECT_DONE(driver.drag_object(panel, {0.5, 0.3, 0.0}));
        EXPECT_DONE(driver.press("5"));
        EXPECT_TRUE(driver.wait_settled());
        return driver.picture();
    };
    const Image first = picture();
    const Image second = picture();
    EXPECT_EQ(first.width, 1280);
    EXPECT_TRUE(first.rgba == second.rgba);
}

TEST(TheDesk, closes_menus_on_escape_and_then_lets_go_of_the_selection) {
    Driver driver(setup());
    EXPECT_DONE(driver.click("tree." + panel));
    EXPECT_DONE(driver.click("menu.Edit"));
    EXPECT_NE(driver.workbench().widgets().find("edit.duplicate"), nullptr);
    EXPECT_DONE(driver.press("Esc"));
    EXPECT_EQ(driver.workbench().widgets().find("edit.duplicate"), nullptr);
    EXPECT_EQ(state(driver, "selected"), panel);
    EXPECT_DONE(driver.press("Esc"));
    EXPECT_EQ(state(driver, "selected"), "");
}

TEST(TheDesk, stops_computing_on_escape_and_computes_after_the_next_change) {
    Driver::Setup slow = setup();
    slow.content.settings.max_patch = 0.06;  // minutes
    Driver driver(std::move(slow));
    ASSERT_TRUE(driver.wait_until([&] { return driver.workbench().study().is_cancellable(); }));
    EXPECT_DONE(driver.press("Esc"));
    ASSERT_TRUE(driver.wait_until([&] { return !driver.workbench().study().busy(); }, 10.0));
    EXPECT_EQ(state(driver, "fresh"), "false");
    EXPECT_EQ(state(driver, "settled"), "true") << "nothing more will come";
    EXPECT_DONE(driver.click("tree." + panel));
    EXPECT_DONE(driver.press("Up"));
    EXPECT_EQ(state(driver, "busy"), "true");
}

TEST(TheDesk, fits_small_and_dense_screens) {
    for (const float scale : {1.0F, 2.0F}) {
        Driver::Setup dense = setup();
        dense.size = {static_cast<int>(1280 * scale), static_cast<int>(800 * scale)};
        dense.scale = scale;
        Driver driver(std::move(dense));
        EXPECT_DONE(driver.click("tree." + panel));
        const ScreenRect* field = driver.workbench().widgets().find("luminaire.z");
        ASSERT_NE(field, nullptr);
        EXPECT_LT(field->right, 1280.0F * scale);
        EXPECT_GT(field->right - field->left, 80.0F * scale);  // "-123.456" with room around it
    }
}

TEST(AScript, records_a_drag_by_the_clock_and_reports_how_long_answers_took) {
    const std::filesystem::path folder = scratch("strip");
    std::filesystem::remove_all(folder);
    Driver driver(setup());
    std::ostringstream out;
    const std::string script = "wait converged\nrecord \"" + folder.string() + "\" every 5\n" + "drag object \"" +
                               panel + "\" by 0.8 0 0 in 0.5\nwait converged\nreport latency\n";
    const auto fault = play_script(script, "drag", driver, out);
    ASSERT_FALSE(fault) << to_text(*fault);
    EXPECT_NE(out.str().find("frames: "), std::string::npos);
    EXPECT_NE(out.str().find("answers: "), std::string::npos);
    EXPECT_EQ(out.str().find("answers: none"), std::string::npos);
    const std::vector<std::filesystem::path> pictures(std::filesystem::directory_iterator(folder), {});
    EXPECT_GE(pictures.size(), 3U);
    EXPECT_TRUE(play_script("report latency\n", "drag", driver, out)) << "nothing is being recorded";
    EXPECT_TRUE(play_script("record nowhere every 0\n", "drag", driver, out));
}

TEST(AScript, says_what_is_wrong_with_the_line_it_stands_in) {
    Driver driver(setup());
    std::ostringstream out;
    const auto fault = play_script("wait 1\n# a remark\nclick nonsense\n", "a.script", driver, out);
    ASSERT_TRUE(fault);
    EXPECT_EQ(fault->place.line, 3);
    EXPECT_EQ(to_text(*fault), "a.script:3: click: there is no widget \"nonsense\" on the screen");
    EXPECT_TRUE(play_script("expect selected \"Cooler\"\n", "b.script", driver, out));
    EXPECT_FALSE(
        play_script("click \"tree.Cooler\"\nexpect selected \"Cooler\"\nprint selected\n", "c.script", driver, out));
    EXPECT_EQ(out.str(), "selected: Cooler\n");
}

}  // namespace
}  // namespace hanei
