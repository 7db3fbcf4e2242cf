#include "ui/panels/messages.h"

#include "engine/edit/edit.h"
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
