#include "ui/panels/edit_history.h"

#include "engine/edit/edit.h"
#include "ui/panels/command_search.h"
#include "ui/panels/context_menu.h"
#include "ui/panels/document.h"

#include <gtest/gtest.h>
#include <set>

namespace hanei {
namespace {

Scene titled(const std::string& title) {
    Scene scene;
    scene.title = title;
    return scene;
}
SceneSnapshot snapshot(const std::string& title) { return std::make_shared<const Scene>(titled(title)); }

TEST(History, undo_gives_back_the_very_scene_before_the_step) {
    EditHistory history(titled("empty"), {});
    const SceneSnapshot before = history.now();
    history.commit(snapshot("one desk"), {}, "Add desk");
    EXPECT_EQ(history.undo_name(), "Add desk");
    history.undo();
    EXPECT_EQ(history.now(), before);
    EXPECT_EQ(history.redo_name(), "Add desk");
    history.redo();
    EXPECT_EQ(history.now()->title, "one desk");
}

TEST(History, a_new_step_drops_what_was_undone) {
    EditHistory history(titled("empty"), {});
    history.commit(snapshot("one desk"), {}, "Add desk");
    history.undo();
    history.commit(snapshot("one chair"), {}, "Add chair");
    EXPECT_FALSE(history.can_redo());
    EXPECT_EQ(history.depth(), 1U);
}

TEST(History, what_is_unchanged_makes_no_step_and_the_ends_hold) {
    EditHistory history(titled("empty"), {});
    history.commit(snapshot("empty"), {}, "Move nothing");
    EXPECT_FALSE(history.can_undo());
    history.undo();
    history.redo();
    history.go_to(99);
    EXPECT_EQ(history.now()->title, "empty");
    EXPECT_TRUE(history.undo_name().empty());
}

TEST(History, keeps_far_more_than_five_hundred_steps_and_goes_to_any) {
    EditHistory history(titled("0"), {});
    for (int k = 1; k <= 600; ++k) history.commit(snapshot(std::to_string(k)), {}, "Step " + std::to_string(k));
    EXPECT_EQ(history.depth(), 600U);
    history.go_to(17);
    EXPECT_EQ(history.now()->title, "17");
    EXPECT_EQ(history.undo_name(), "Step 17");
    EXPECT_EQ(history.redo_name(), "Step 18");
    history.go_to(600);
    for (int k = 0; k < 600; ++k) history.undo();
    EXPECT_EQ(history.now()->title, "0");
    for (std::size_t k = 601; k <= EditHistory::most_steps + 100; ++k)
        history.commit(snapshot(std::to_string(k)), {}, "more");
    EXPECT_LE(history.size(), EditHistory::most_steps);
}

TEST(History, undoing_back_to_what_was_saved_leaves_nothing_unsaved) {
    EditHistory history(titled("empty"), {});
    history.commit(snapshot("one desk"), {}, "Add desk");
    EXPECT_FALSE(history.is_saved());
    history.undo();
    EXPECT_TRUE(history.is_saved());
}

TEST(Document, changed_settings_are_a_step_that_undo_takes_back) {
    Document document({empty_room(), {}});
    const Settings before = document.settings();
    Settings wished = before;
    for (const int bounces : {3, 4, 5}) {
        wished.bounces = bounces;
        document.set_settings(wished);
    }
    EXPECT_TRUE(document.in_gesture());
    document.settle();
    EXPECT_EQ(document.history().depth(), 1U);
    EXPECT_EQ(document.history().undo_name(), "Change calculation");
    EXPECT_EQ(document.settings(), wished);
    document.undo();
    EXPECT_EQ(document.settings(), before);
    EXPECT_TRUE(document.is_saved());
    document.redo();
    EXPECT_EQ(document.settings(), wished);
}

TEST(ASearch, finds_commands_by_words_of_their_names_menus_and_help) {
    ASSERT_FALSE(commands_matching("undo").empty());
    EXPECT_EQ(commands_matching("undo").front()->id, CommandId::undo);
    EXPECT_EQ(commands_matching("PASTE").front()->id, CommandId::paste);
    EXPECT_EQ(commands_matching("").size(), commands().size());
    EXPECT_TRUE(commands_matching("no such thing").empty());
    const auto found = commands_matching("edit 90");
    EXPECT_FALSE(found.empty()) << "words in any order and place";
}

TEST(AContextMenu, holds_each_command_once) {
    for (int kind = 0; kind <= static_cast<int>(ObjectKind::object_group); ++kind) {
        std::set<CommandId> seen;
        for (const CommandId id : context_commands(static_cast<ObjectKind>(kind))) {
            if (id == CommandId::quit) continue;  // a line
            EXPECT_TRUE(seen.insert(id).second) << command(id).name;
        }
        EXPECT_GT(seen.size(), 5U);
    }
}

}  // namespace
}  // namespace hanei
