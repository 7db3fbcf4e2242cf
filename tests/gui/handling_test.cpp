#include "computer_room.h"
#include "engine/edit/several.h"
#include "ui/panels/state_text.h"
#include "ui/window/driver.h"
#include "ui/window/script.h"

#include <gtest/gtest.h>
#include <imgui.h>
#include <sstream>

namespace hanei {
namespace {

std::string state(const Driver& driver, const std::string& name) { return state_of(driver.workbench())[name]; }
double figure(const Driver& driver, const std::string& name) { return std::stod(state(driver, name)); }

#define EXPECT_DONE(action) EXPECT_EQ(action, "")

/// Plays the lines; the sentence of their first fault.
std::string play(Driver& driver, const std::string& lines) {
    std::ostringstream out;
    const auto fault = play_script(lines, "handling", driver, out);
    return fault ? to_text(*fault) : std::string();
}

TEST(AHandle, takes_a_typed_length_and_ends_on_enter) {
    Driver driver(computer_room());
    EXPECT_DONE(driver.click("tree.Ceiling panel 1"));
    const double x = figure(driver, "selected.x"), y = figure(driver, "selected.y");
    EXPECT_DONE(play(driver, "hold handle.x\nmove 30 0\ntype 1.25\nkey Enter\nrelease\n"));
    EXPECT_NEAR(figure(driver, "selected.x"), x + 1.25, 1e-9);
    EXPECT_EQ(figure(driver, "selected.y"), y);
    EXPECT_EQ(state(driver, "undo depth"), "1");
    EXPECT_EQ(state(driver, "undo"), "Move luminaire");
}

TEST(AHandle, is_given_up_on_escape) {
    Driver driver(computer_room());
    const SceneSnapshot before = driver.workbench().document().shown();
    EXPECT_DONE(driver.click("tree.Ceiling panel 1"));
    EXPECT_DONE(play(driver, "hold handle.plane\nmove 60 10\nkey Esc\nrelease\n"));
    EXPECT_EQ(*driver.workbench().document().shown(), *before);
    EXPECT_EQ(state(driver, "undo depth"), "0");
    EXPECT_EQ(state(driver, "selected"), "Ceiling panel 1") << "Escape ended the drag alone";
}

TEST(AHandle, turns_by_its_ring) {
    Driver driver(computer_room());
    EXPECT_DONE(driver.click("tree.Ceiling panel 1"));
    EXPECT_DONE(play(driver, "hold handle.rotate\nmove 20 0\ntype 30\nkey Enter\nrelease\n"));
    EXPECT_NEAR(figure(driver, "yaw"), 30.0, 1e-6);
    EXPECT_EQ(state(driver, "undo"), "Turn luminaire");
}

TEST(TheClipboard, carries_objects_from_one_project_to_another) {
    Driver driver(computer_room());
    EXPECT_DONE(driver.click("tree.Ceiling panel 1"));
    EXPECT_DONE(driver.click("tree.Cooler", 0, {true, false, false}));
    EXPECT_DONE(driver.press("Ctrl+C"));
    const std::string text = ImGui::GetClipboardText();
    EXPECT_DONE(driver.press("Ctrl+X"));
    EXPECT_EQ(state(driver, "luminaires"), "1");
    EXPECT_DONE(driver.press("Ctrl+V"));
    EXPECT_EQ(state(driver, "luminaires"), "2");
    EXPECT_EQ(state(driver, "undo"), "Paste 2 objects");
    EXPECT_EQ(state(driver, "selected count"), "2");
    Driver other({{empty_room(), {}}, {}, project_door()});
    ImGui::SetClipboardText(text.c_str());
    EXPECT_DONE(other.press("Ctrl+V"));
    EXPECT_EQ(state(other, "luminaires"), "1");
    EXPECT_EQ(state(other, "furniture"), "1");
}

TEST(TheClipboard, with_anything_else_answers_with_a_sentence) {
    Driver driver(computer_room());
    for (const char* text : {"", "good morning", "{", "{\"scene\": 3}", "[[[[[[[[", "\xFF\xFE"}) {
        ImGui::SetClipboardText(text);
        EXPECT_DONE(driver.press("Ctrl+V"));
        EXPECT_EQ(state(driver, "undo depth"), "0") << text;
        EXPECT_EQ(state(driver, "message").rfind("The clipboard holds no objects of a project", 0), 0U) << text;
    }
}

TEST(TheMenus, of_the_right_button_and_the_search_carry_commands_out) {
    Driver driver(computer_room());
    EXPECT_DONE(driver.click("tree.Cooler", 1));
    driver.frames(2);
    EXPECT_EQ(state(driver, "selected"), "Cooler");
    EXPECT_DONE(driver.click("context.edit.duplicate"));
    EXPECT_EQ(state(driver, "undo"), "Duplicate furniture");
    EXPECT_DONE(driver.press("F3"));
    driver.type("undo");
    EXPECT_DONE(driver.press("Enter"));
    EXPECT_EQ(state(driver, "undo depth"), "0");
    EXPECT_DONE(driver.press("Esc"));
    EXPECT_DONE(play(driver, "right object \"Side table\"\nclick context.edit.delete\n"));
    EXPECT_EQ(state(driver, "undo"), "Delete Side table");
    EXPECT_DONE(driver.press("Ctrl+H"));
    EXPECT_DONE(driver.click("history.0"));
    EXPECT_EQ(state(driver, "undo depth"), "0");
}

}  // namespace
}  // namespace hanei
