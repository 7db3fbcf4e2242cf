/// The program checked at its own desk: the table of reference cases, and values of others.
#include "ui/panels/checks.h"

#include "bare_desk.h"
#include "computer_room.h"

#include <chrono>
#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <imgui.h>
#include <thread>

namespace hanei {
namespace {

struct Look {
    float scale = 1.0F, width = 1280.0F, height = 800.0F;
    Language language = Language::english;
};

/// Hands out as many rows as there are rules, then signs.
std::optional<Validation> quick_run(const Work& work, const std::function<void(const ValidationRow&)>& told) {
    Validation made{"9.9", "2030-01-02", "linear", 2, 0.5, {}};
    for (int k = 0; k < 40; ++k) {
        if (work.stop.stop_requested()) return std::nullopt;
        made.rows.push_back({"P-A1", "Point source: inverse square and cosine law", "closed form", 12, 1e-9, 1e-3,
                             1e-10, 0.1, k == 7 ? Grade::fail : Grade::top, k == 7 ? "worst: 3" : ""});
        told(made.rows.back());
    }
    return made;
}

class Checking {
public:
    explicit Checking(RunValidation run, double patience = 60.0, const Look& look = {})
        : look_(look),
          desk_({computer_room().content.scene, computer_room().content.settings}, door_with(std::move(run)),
                {look.width, look.height}, {true, patience}, look.scale, look.language) {
        frames(3);
    }
    void frames(int count) {
        for (int k = 0; k < count; ++k) desk_.frame();
    }
    const ScreenRect* find(const std::string& widget) { return desk_.workbench().widgets().find(widget); }
    testing::AssertionResult click(const std::string& widget) {
        const ScreenRect* const rect = find(widget);
        if (rect == nullptr) return testing::AssertionFailure() << "no widget " << widget;
        if (rect->right > look_.width || rect->bottom > look_.height || rect->left < 0.0F)
            return testing::AssertionFailure() << widget << " is not on the screen";
        desk_.input().mouse_move(rect->x(), rect->y());
        desk_.input().mouse_button(0, true);
        desk_.input().mouse_button(0, false);
        desk_.run_queue();
        frames(3);
        return testing::AssertionSuccess();
    }
    void type(std::string_view text) {
        desk_.input().text(text);
        desk_.run_queue();
        frames(2);
    }
    template <class So>
    bool wait_until(So so) {
        const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(120);
        while (!so() && std::chrono::steady_clock::now() < end) {
            desk_.frame();
            std::this_thread::sleep_for(std::chrono::milliseconds(5));
        }
        return so();
    }
    const Workbench& workbench() const { return desk_.workbench(); }
    const ValidationDialog& validation() const { return workbench().checks().validation; }
    const TrustDialog& trust() const { return workbench().checks().trust; }
    const MeasuredDialog& measured() const { return workbench().checks().measured; }

private:
    static ProjectDoor door_with(RunValidation run) {
        ProjectDoor door = project_door();
        if (run) door.validate = std::move(run);
        return door;
    }
    Look look_;
    BareDesk desk_;
};

TEST(Checks, help_opens_the_table_of_reference_cases_with_its_verdict) {
    Checking desk(quick_run);
    ASSERT_TRUE(desk.click("menu.Help"));
    ASSERT_TRUE(desk.click("help.validation"));
    EXPECT_TRUE(desk.validation().is_open());
    ASSERT_TRUE(desk.validation().validation());
    EXPECT_EQ(desk.validation().rows(), 40U);
    EXPECT_NE(desk.find("validation.verdict"), nullptr);
    ASSERT_TRUE(desk.click("validation.copy"));
    EXPECT_NE(std::string(ImGui::GetClipboardText()).find("1 of 40 cases fail"), std::string::npos);
    ASSERT_TRUE(desk.click("validation.csv"));
    EXPECT_EQ(std::string(ImGui::GetClipboardText()).rfind("case,proves", 0), 0U);
    ASSERT_TRUE(desk.click("validation.close"));
    EXPECT_FALSE(desk.validation().is_open());
}

TEST(Checks, the_table_and_its_buttons_fit_at_every_scale_and_in_japanese) {
    for (const Look& look :
         {Look{1.0F, 800.0F, 600.0F}, Look{2.0F, 1920.0F, 1080.0F, Language::japanese}, Look{3.0F, 2560.0F, 1440.0F}}) {
        Checking desk(quick_run, 60.0, look);
        ASSERT_TRUE(desk.click("menu.Help")) << look.scale;
        ASSERT_TRUE(desk.click("help.validation")) << look.scale;
        for (const char* button : {"validation.copy", "validation.csv", "validation.close"})
            EXPECT_TRUE(desk.click(button)) << look.scale;
        EXPECT_FALSE(desk.validation().is_open()) << look.scale;
    }
}

TEST(Checks, the_programs_own_cases_run_beside_the_frames_and_can_be_stopped) {
    Checking desk(nullptr, 0.0);
    ASSERT_TRUE(desk.click("menu.Help"));
    ASSERT_TRUE(desk.click("help.validation"));
    ASSERT_TRUE(desk.wait_until([&] { return desk.validation().rows() >= 3; }));
    if (desk.validation().busy()) {
        ASSERT_TRUE(desk.click("validation.cancel"));
        EXPECT_FALSE(desk.validation().busy());
        EXPECT_FALSE(desk.validation().validation());
        EXPECT_NE(desk.find("validation.again"), nullptr);
    }
    ASSERT_TRUE(desk.click("validation.close"));
    EXPECT_FALSE(desk.validation().is_open());
}

TEST(Checks, a_run_that_fails_says_why_and_closes) {
    Checking desk([](const Work&, const auto&) -> std::optional<Validation> { throw std::runtime_error("no cases"); });
    ASSERT_TRUE(desk.click("menu.Help"));
    ASSERT_TRUE(desk.click("help.validation"));
    EXPECT_FALSE(desk.validation().validation());
    ASSERT_TRUE(desk.click("validation.close"));
    EXPECT_FALSE(desk.validation().is_open());
}

TEST(Checks, the_answer_is_checked_from_the_results_menu_and_told_as_text_and_json) {
    Checking desk(quick_run, 600.0, {2.0F, 1920.0F, 1080.0F, Language::japanese});
    ASSERT_TRUE(desk.wait_until([&] { return desk.workbench().study().settled(); }));
    ASSERT_TRUE(desk.click("menu.Results"));
    ASSERT_TRUE(desk.click("results.trust"));
    EXPECT_TRUE(desk.trust().is_open());
    ASSERT_TRUE(desk.trust().report());
    EXPECT_TRUE(desk.trust().report()->holds()) << trust_text(*desk.trust().report());
    EXPECT_EQ(desk.trust().done(), TrustReport::checks);
    EXPECT_NE(desk.find("trust.verdict"), nullptr);
    ASSERT_TRUE(desk.click("trust.copy"));
    EXPECT_EQ(std::string(ImGui::GetClipboardText()), trust_text(*desk.trust().report()));
    ASSERT_TRUE(desk.click("trust.json"));
    EXPECT_EQ(std::string(ImGui::GetClipboardText()), trust_json(*desk.trust().report()));
    ASSERT_TRUE(desk.click("trust.close"));
    EXPECT_FALSE(desk.trust().is_open());
}

TEST(Checks, a_check_of_the_answer_runs_beside_the_frames_and_can_be_stopped) {
    Checking desk(quick_run, 0.0);
    ASSERT_TRUE(desk.wait_until([&] { return desk.workbench().study().settled(); }));
    ASSERT_TRUE(desk.click("menu.Results"));
    ASSERT_TRUE(desk.click("results.trust"));
    if (desk.trust().busy()) {
        ASSERT_TRUE(desk.click("trust.cancel"));
        EXPECT_FALSE(desk.trust().busy());
        EXPECT_FALSE(desk.trust().report());
        EXPECT_NE(desk.find("trust.again"), nullptr);
    }
    ASSERT_TRUE(desk.click("trust.close"));
    EXPECT_FALSE(desk.trust().is_open());
}

class Measured : public testing::Test {
protected:
    void compare(const std::string& table) {
        const auto folder = std::filesystem::path(testing::TempDir()) / "hanei-checks";
        std::filesystem::create_directories(folder);
        const auto file =
            folder / (std::string(testing::UnitTest::GetInstance()->current_test_info()->name()) + ".csv");
        std::ofstream(file) << table;
        ASSERT_TRUE(desk_.wait_until([&] { return desk_.workbench().study().settled(); }));
        ASSERT_TRUE(desk_.click("menu.Results"));
        ASSERT_TRUE(desk_.click("results.measured"));
        ASSERT_TRUE(desk_.click("browser.name"));
        desk_.type(file.string());
        ASSERT_TRUE(desk_.click("browser.accept"));
        desk_.frames(3);
    }
    Checking desk_{quick_run};
};

TEST_F(Measured, values_are_set_beside_ours_from_the_results_menu) {
    compare("X [mm];Y [mm];Z [mm];E [lx];u [%]\n1500;1000;750;400,5;4\n2000;1000;750;100000;4\n");
    ASSERT_TRUE(desk_.measured().is_open());
    ASSERT_EQ(desk_.measured().comparison()->pairs.size(), 2U);
    EXPECT_EQ(desk_.measured().comparison()->sets.at(0).largest, 1U);
    ASSERT_TRUE(desk_.click("measured.csv"));
    EXPECT_EQ(std::string(ImGui::GetClipboardText()).rfind("line,set", 0), 0U);
    ASSERT_TRUE(desk_.click("measured.close"));
    EXPECT_FALSE(desk_.measured().is_open());
}

TEST_F(Measured, a_table_that_cannot_be_used_is_refused_with_its_line) {
    compare("set,index,lux\nNowhere,1,abc\n");
    EXPECT_FALSE(desk_.measured().is_open());
    EXPECT_EQ(desk_.workbench().dialogs().kind(), Dialogs::Kind::findings);
    ASSERT_FALSE(desk_.workbench().dialogs().shown_findings().empty());
    EXPECT_EQ(desk_.workbench().dialogs().shown_findings().front().place.line, 2);
}

}  // namespace
}  // namespace hanei
