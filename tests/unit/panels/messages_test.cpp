#include "ui/panels/messages.h"

#include "engine/edit/edit.h"
#include "ui/panels/messages_panel.h"
#include "ui/panels/scene_difference.h"

#include <gtest/gtest.h>

namespace hanei {
namespace {

TEST(Messages, count_what_comes_again_and_what_was_not_read) {
    Messages messages;
    const Diagnostic error{Severity::error, {}, "the disk is full"};
    for (int k = 0; k < 3; ++k) messages.note("Autosave", error);
    messages.note("File", Diagnostic{Severity::warning, {}, "a field is unknown"});
    ASSERT_EQ(messages.entries().size(), 2U);
    EXPECT_EQ(messages.entries().front().count, 3);
    EXPECT_EQ(messages.unread_errors(), 3U);
    messages.mark_read();
    EXPECT_EQ(messages.unread_errors(), 0U);
    EXPECT_EQ(messages.entries().size(), 2U);
    messages.clear();
    EXPECT_TRUE(messages.entries().empty());
}

TEST(Messages, keep_the_newest_thousand) {
    Messages messages;
    for (int k = 0; k < 1500; ++k) messages.note("Study", Diagnostic{Severity::note, {}, std::to_string(k)});
    EXPECT_EQ(messages.entries().size(), 1000U);
    EXPECT_EQ(messages.entries().back().finding.message, "1499");
}

TEST(Messages, tell_what_is_hard_in_the_scene_once_it_was_asked_for_and_follow_the_scene) {
    const Scene plain = with_panel_luminaire(empty_room()).scene;
    const auto scene = std::make_shared<Scene>(plain);
    const Diagnostics findings{{Severity::warning, {}, "a box is inside another"}};
    MessagesPanel panel;
    EXPECT_EQ(panel.checks_of(scene, findings), findings);
    panel.list_hard_spots();
    const std::size_t before = panel.checks_of(scene, findings).size();
    EXPECT_EQ(panel.checks_of(scene, findings).front().message.substr(0, 20), "no errors, 1 warning");
    const auto dark = std::make_shared<Scene>(plain);
    dark->luminaires.front().dimming = 0.0;
    const Diagnostics& checks = panel.checks_of(dark, findings);
    EXPECT_EQ(checks.size(), before + 1);
    EXPECT_EQ(checks[1], findings.front());
    const auto broken = std::make_shared<Scene>(plain);
    broken->materials.front().reflectance = 2.0;
    const Diagnostics fault{{Severity::error, {}, "it reflects too much"}};
    EXPECT_EQ(panel.checks_of(broken, fault).size(), 2U) << "what is no scene has no hard spots";
}

TEST(Differences, of_scenes_are_told_in_a_few_words) {
    const Scene before = with_panel_luminaire(empty_room()).scene;
    EXPECT_EQ(difference_text(before, before), "Nothing");
    const Added more = with_box(with_panel_luminaire(before).scene);
    EXPECT_EQ(difference_text(before, more.scene).substr(0, 18), "1 luminaire added;");
    EXPECT_NE(difference_text(more.scene, before).find("1 luminaire removed"), std::string::npos);
    Scene renamed = before;
    renamed.title += "!";
    EXPECT_EQ(difference_text(before, renamed), "Title, scale or maintenance factor changed");
}

}  // namespace
}  // namespace hanei
