/// Whether everything that is drawn has its place: at every scale, in both languages, in small windows and large.
#include "bare_desk.h"
#include "computer_room.h"
#include "ui/panels/state_text.h"
#include "ui/panels/window_layout.h"

#include <algorithm>
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <imgui.h>

namespace hanei {
namespace {

struct Look {
    float scale, width, height;
    Language language;
};

std::string name_of(const Look& look) {
    return fmt::format("{:.0f} % {:.0f} x {:.0f} {}", 100.0F * look.scale, look.width, look.height,
                       look.language == Language::japanese ? "ja" : "en");
}

/// What the test framework calls a test by.
void PrintTo(const Look& look, std::ostream* out) { *out << name_of(look); }

using Rects = std::map<std::string, ScreenRect>;

/// The desk at a look, used by names.
class LookedAt {
public:
    explicit LookedAt(const Look& look)
        : look_(look),
          desk_({computer_room().content.scene, computer_room().content.settings}, project_door(),
                {look.width, look.height}, {true}, look.scale, look.language) {
        frames(3);
    }

    void frames(int count) {
        for (int k = 0; k < count; ++k) desk_.frame();
    }
    void carry_out(CommandId id) {
        desk_.workbench().carry_out(id);
        frames(4);
    }
    bool click(const std::string& widget) {
        const ScreenRect* const rect = desk_.workbench().widgets().find(widget);
        if (rect == nullptr || rect->x() > look_.width || rect->y() > look_.height) return false;
        desk_.input().mouse_move(rect->x(), rect->y());
        desk_.input().mouse_button(0, true);
        desk_.input().mouse_button(0, false);
        desk_.run_queue();
        frames(3);
        return true;
    }
    void press(Key key) {
        desk_.input().key(key, true);
        desk_.input().key(key, false);
        desk_.run_queue();
        frames(3);
    }
    const Rects& rects() const { return desk_.workbench().widgets().all(); }
    Workbench& workbench() { return desk_.workbench(); }
    WindowLayout layout() const {
        return lay_out(desk_.workbench().preferences(), look_.width, look_.height, ImGui::GetFrameHeight(),
                       look_.scale);
    }

private:
    Look look_;
    BareDesk desk_;
};

Rects added(const Rects& before, const Rects& after) {
    Rects news;
    for (const auto& [name, rect] : after)
        if (!before.contains(name)) news[name] = rect;
    return news;
}

Rects of_family(const Rects& all, const std::string& family) {
    Rects found;
    for (const auto& [name, rect] : all)
        if (name.starts_with(family)) found[name] = rect;
    return found;
}

/// Rows touch each other; more than that is an overlap.
void expect_apart(const Rects& rects, const std::string& where) {
    constexpr float touch = 1.5F;
    for (auto one = rects.begin(); one != rects.end(); ++one) {
        for (auto other = std::next(one); other != rects.end(); ++other) {
            const ScreenRect &a = one->second, &b = other->second;
            const float across = std::min(a.right, b.right) - std::max(a.left, b.left);
            const float down = std::min(a.bottom, b.bottom) - std::max(a.top, b.top);
            EXPECT_FALSE(across > touch && down > touch)
                << where << ": " << one->first << " lies over " << other->first << " by " << across << " x " << down;
        }
    }
}

void expect_within(const Rects& rects, float left, float right, const std::string& where) {
    for (const auto& [name, rect] : rects) {
        EXPECT_GE(rect.left, left - 1.0F) << where << ": " << name;
        EXPECT_LE(rect.right, right + 1.0F) << where << ": " << name;
        EXPECT_GE(rect.right - rect.left, 4.0F) << where << ": " << name << " is squeezed";
    }
}

class EveryWidget : public testing::TestWithParam<Look> {};

TEST_P(EveryWidget, of_bars_and_tabs_has_a_place_of_its_own) {
    LookedAt desk(GetParam());
    const WindowLayout layout = desk.layout();
    const std::string where = name_of(GetParam());
    for (const char* family : {"menu.", "tool.", "view.", "tab."}) {
        Rects found = of_family(desk.rects(), family);
        ASSERT_FALSE(found.empty()) << family;
        if (std::string(family) == "tab.")  // those that are rolled out of sight
            std::erase_if(found, [](const auto& entry) { return entry.second.right - entry.second.left < 4.0F; });
        expect_apart(found, where);
        if (std::string(family) != "tab.") expect_within(found, 0.0F, GetParam().width, where);
    }
    expect_within(of_family(desk.rects(), "view."), layout.centre.left, layout.centre.right, where);
    expect_within(of_family(desk.rects(), "tree."), layout.left.left, layout.left.right, where);
    expect_apart(of_family(desk.rects(), "tree."), where);
}

TEST_P(EveryWidget, of_a_luminaires_and_the_lights_fields_is_within_its_panel) {
    LookedAt desk(GetParam());
    desk.workbench().choose(desk.workbench().document().shown()->luminaires.front().id);
    desk.frames(3);
    const ScreenRect area = desk.layout().right;
    for (const char* tab : {"tab.Calculation", "tab.Light", "tab.Photometry", "tab.Properties"}) {
        const Rects before = desk.rects();
        if (!desk.click(tab)) continue;
        const Rects news = added(before, desk.rects());
        expect_apart(news, name_of(GetParam()) + " " + tab);
        expect_within(news, area.left, area.right, name_of(GetParam()) + " " + tab);
    }
}

TEST_P(EveryWidget, of_a_dialog_is_on_the_screen_and_its_button_to_leave_it_can_be_reached) {
    struct Dialog {
        CommandId command;
        const char* leave;
    };
    for (const Dialog& dialog :
         {Dialog{CommandId::edit_preferences, "preferences.close"}, Dialog{CommandId::show_keys, "keys.close"},
          Dialog{CommandId::show_about, "about.close"}, Dialog{CommandId::new_room_dialog, nullptr},
          Dialog{CommandId::light_layout, nullptr}, Dialog{CommandId::array_copies, nullptr},
          Dialog{CommandId::command_search, nullptr}}) {
        LookedAt desk(GetParam());
        desk.workbench().choose(desk.workbench().document().shown()->luminaires.front().id);
        desk.frames(2);
        const Rects before = desk.rects();
        desk.carry_out(dialog.command);
        Rects news = added(before, desk.rects());
        std::erase_if(news, [](const auto& entry) { return entry.first.starts_with("tree."); });  // of a preview
        const std::string where = fmt::format("{} {}", name_of(GetParam()), command(dialog.command).name);
        ASSERT_FALSE(news.empty()) << where;
        expect_apart(news, where);
        expect_within(news, 0.0F, GetParam().width, where);
        if (dialog.leave == nullptr) continue;
        ASSERT_TRUE(news.contains(dialog.leave)) << where;
        EXPECT_LE(news.at(dialog.leave).bottom, GetParam().height) << where;
        EXPECT_TRUE(desk.click(dialog.leave)) << where;
        EXPECT_FALSE(desk.rects().contains(dialog.leave)) << where;
    }
}

INSTANTIATE_TEST_SUITE_P(
    Looks, EveryWidget,
    testing::Values(Look{1.0F, 800.0F, 600.0F, Language::english}, Look{1.0F, 1280.0F, 800.0F, Language::japanese},
                    Look{2.0F, 1280.0F, 800.0F, Language::english}, Look{2.0F, 1280.0F, 800.0F, Language::japanese},
                    Look{3.0F, 2560.0F, 1440.0F, Language::english}, Look{3.0F, 2560.0F, 1440.0F, Language::japanese}));

#define EXPECT_DONE(action) EXPECT_EQ(action, "")

std::string state(const Driver& driver, const std::string& name) { return state_of(driver.workbench())[name]; }

TEST(APin, is_chosen_by_a_click_on_its_label_and_moved_by_a_drag) {
    Driver driver(computer_room());
    ASSERT_TRUE(driver.wait_settled());
    const std::string pin = "pin.Desk B, beside the terminal";
    EXPECT_DONE(driver.click(pin));
    EXPECT_EQ(state(driver, "selected"), "Desk B, beside the terminal");
    EXPECT_EQ(state(driver, "undo depth"), "0");
    const CalculationPoint before = driver.workbench().document().shown()->points[1];
    EXPECT_DONE(driver.drag(pin, 60.0F, 20.0F));
    const CalculationPoint after = driver.workbench().document().shown()->points[1];
    EXPECT_GT(glm::length(after.position - before.position), 0.05);
    EXPECT_EQ(after.position.z, before.position.z);
    EXPECT_EQ(state(driver, "undo depth"), "1");
}

TEST(TheSearch, lists_what_can_be_done_before_what_cannot) {
    Driver driver(computer_room());
    EXPECT_DONE(driver.press("F3"));
    driver.frames(3);
    float lowest_possible = 0.0F, highest_impossible = 1e9F;
    for (const Command& entry : commands()) {
        const ScreenRect* const row = driver.workbench().widgets().find("search." + std::string(entry.name));
        if (row == nullptr) continue;
        if (driver.workbench().can(entry.id))
            lowest_possible = std::max(lowest_possible, row->top);
        else
            highest_impossible = std::min(highest_impossible, row->top);
    }
    EXPECT_GT(lowest_possible, 0.0F);
    EXPECT_LT(highest_impossible, 1e9F);
    EXPECT_LT(lowest_possible, highest_impossible);
}

TEST(TheLibrary, keeps_what_was_being_changed_when_a_piece_is_clicked) {
    Driver driver(computer_room());
    EXPECT_DONE(driver.click("tree.Ceiling panel 1"));
    EXPECT_DONE(driver.click("tab.Furniture"));
    Workbench& desk = driver.workbench();
    const std::size_t pieces = desk.document().shown()->furniture.size();
    EXPECT_DONE(driver.click("luminaire.x"));
    driver.type("1.5");
    const auto& all = desk.widgets().all();
    const auto tile = std::find_if(all.begin(), all.end(), [](const auto& entry) {
        return entry.first.starts_with("library.") && entry.first != "library.search" && entry.second.bottom < 700.0F;
    });
    ASSERT_NE(tile, all.end());
    EXPECT_DONE(driver.click(std::string(tile->first)));
    driver.frames(3);
    EXPECT_EQ(desk.document().shown()->furniture.size(), pieces + 1);
    EXPECT_NEAR(desk.document().shown()->luminaires.front().position.x, 1.5, 1e-9);
}

}  // namespace
}  // namespace hanei
