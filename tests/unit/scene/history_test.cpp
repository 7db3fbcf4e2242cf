#include "engine/scene/history.h"

#include <gtest/gtest.h>

namespace hanei {
namespace {

Scene titled(const char* title) {
    Scene scene;
    scene.title = title;
    return scene;
}

TEST(History, undo_gives_back_the_very_scene_before_the_step) {
    History history{titled("empty")};
    const SceneSnapshot before = history.now();
    history.commit(titled("one desk"), "Add desk");
    EXPECT_EQ(history.now()->title, "one desk");
    EXPECT_EQ(history.undo_name(), "Add desk");
    history.undo();
    EXPECT_EQ(history.now(), before);
    EXPECT_EQ(history.redo_name(), "Add desk");
    history.redo();
    EXPECT_EQ(history.now()->title, "one desk");
}

TEST(History, a_new_step_drops_what_was_undone) {
    History history{titled("empty")};
    history.commit(titled("one desk"), "Add desk");
    history.undo();
    history.commit(titled("one chair"), "Add chair");
    EXPECT_FALSE(history.can_redo());
    EXPECT_EQ(history.depth(), 1U);
    history.undo();
    EXPECT_EQ(history.redo_name(), "Add chair");
}

TEST(History, an_unchanged_scene_makes_no_step) {
    History history{titled("empty")};
    history.commit(titled("empty"), "Move nothing");
    EXPECT_FALSE(history.can_undo());
}

TEST(History, the_ends_of_the_stack_hold) {
    History history{titled("empty")};
    history.undo();
    history.redo();
    EXPECT_EQ(history.now()->title, "empty");
    EXPECT_TRUE(history.undo_name().empty());
    EXPECT_TRUE(history.redo_name().empty());
}

TEST(History, undoing_back_to_the_saved_scene_leaves_nothing_unsaved) {
    History history{titled("empty")};
    EXPECT_TRUE(history.is_saved());
    history.commit(titled("one desk"), "Add desk");
    EXPECT_FALSE(history.is_saved());
    history.undo();
    EXPECT_TRUE(history.is_saved());
    history.redo();
    history.mark_saved();
    EXPECT_TRUE(history.is_saved());
}

}  // namespace
}  // namespace hanei
