#include "ui/panels/document.h"

#include "engine/edit/edit.h"

#include <gtest/gtest.h>

namespace hanei {
namespace {

TEST(Document, a_gesture_of_many_scenes_is_one_step_that_undo_takes_back) {
    const Added lamp = with_point_luminaire(empty_room());
    Document document({lamp.scene, {}});
    const SceneSnapshot before = document.shown();
    for (int k = 1; k <= 20; ++k) document.propose(moved(*before, lamp.object, {0.01 * k, 0.0, 0.0}), "Move luminaire");
    EXPECT_TRUE(document.in_gesture());
    document.settle();
    EXPECT_EQ(document.history().depth(), 1U);
    EXPECT_EQ(document.history().undo_name(), "Move luminaire");
    document.undo();
    EXPECT_EQ(document.shown(), before);
}

TEST(Document, a_gesture_that_ends_where_it_began_is_no_step) {
    const Added lamp = with_point_luminaire(empty_room());
    Document document({lamp.scene, {}});
    document.propose(moved(lamp.scene, lamp.object, {0.5, 0.0, 0.0}), "Move luminaire");
    document.propose(lamp.scene, "Move luminaire");
    document.settle();
    EXPECT_EQ(document.history().depth(), 0U);
    EXPECT_TRUE(document.is_saved());
}

TEST(Document, changed_settings_are_unsaved_changes) {
    Document document({empty_room(), {}});
    Settings settings = document.settings();
    settings.bounces = 3;
    document.set_settings(settings);
    EXPECT_FALSE(document.is_saved());
    document.mark_saved("room.hanei");
    EXPECT_TRUE(document.is_saved());
    EXPECT_EQ(document.title(), "room");
}

}  // namespace
}  // namespace hanei
