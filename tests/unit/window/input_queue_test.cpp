#include "ui/window/input_queue.h"

#include <gtest/gtest.h>
#include <imgui.h>

namespace hanei {
namespace {

class AnInputQueue : public testing::Test {
protected:
    AnInputQueue() : context(ImGui::CreateContext()), io(ImGui::GetIO()) { map_keys(io); }
    ~AnInputQueue() override { ImGui::DestroyContext(context); }
    void feed() { queue.feed(io); }

    ImGuiContext* context;
    ImGuiIO& io;
    InputQueue queue;
};

TEST_F(AnInputQueue, shows_a_click_shorter_than_a_frame_for_one_frame) {
    queue.mouse_button(0, true);
    queue.mouse_button(0, false);
    feed();
    EXPECT_TRUE(io.MouseDown[0]);
    feed();
    EXPECT_FALSE(io.MouseDown[0]);
    EXPECT_TRUE(queue.empty());
}

TEST_F(AnInputQueue, presses_where_the_pointer_was_and_not_where_it_went_afterwards) {
    queue.mouse_move(10.0F, 10.0F);
    queue.mouse_move(20.0F, 30.0F);
    queue.mouse_button(0, true);
    queue.mouse_move(90.0F, 90.0F);
    feed();
    EXPECT_TRUE(io.MouseDown[0]);
    EXPECT_EQ(io.MousePos.x, 20.0F);
    EXPECT_EQ(io.MousePos.y, 30.0F);
    feed();
    EXPECT_EQ(io.MousePos.x, 90.0F);
}

TEST_F(AnInputQueue, keeps_the_modifier_down_while_its_letter_is_pressed) {
    queue.key(Key::left_control, true);
    queue.key(key_of('Z'), true);
    queue.key(Key::left_control, false);
    queue.key(key_of('Z'), false);
    feed();
    EXPECT_TRUE(io.KeyCtrl);
    feed();
    EXPECT_TRUE(io.KeyCtrl);
    EXPECT_TRUE(io.KeysDown['Z']);
    feed();
    EXPECT_FALSE(io.KeyCtrl);
    feed();
    EXPECT_FALSE(io.KeysDown['Z']);
}

TEST_F(AnInputQueue, loses_none_of_ten_fast_clicks) {
    for (int k = 0; k < 10; ++k) {
        queue.mouse_button(0, true);
        queue.mouse_button(0, false);
    }
    int presses = 0;
    for (bool before = false; !queue.empty(); before = io.MouseDown[0]) {
        feed();
        if (io.MouseDown[0] && !before) ++presses;
    }
    EXPECT_EQ(presses, 10);
}

TEST_F(AnInputQueue, reads_text_as_utf_8) {
    queue.text("4é€");
    feed();
    ASSERT_EQ(io.InputQueueCharacters.Size, 3);
    EXPECT_EQ(io.InputQueueCharacters[0], '4');
    EXPECT_EQ(io.InputQueueCharacters[1], 0xE9);
    EXPECT_EQ(io.InputQueueCharacters[2], 0x20AC);
}

TEST_F(AnInputQueue, lets_go_of_everything_when_the_window_loses_the_keyboard) {
    queue.key(Key::left_control, true);
    queue.mouse_button(0, true);
    feed();
    feed();
    queue.focus(false);
    feed();
    EXPECT_FALSE(io.KeyCtrl);
    EXPECT_FALSE(io.MouseDown[0]);
}

TEST_F(AnInputQueue, hands_over_dropped_files_once_and_where_the_pointer_was) {
    queue.mouse_move(40.0F, 50.0F);
    queue.drop({"a.ies", "b.ldt"});
    queue.mouse_move(90.0F, 90.0F);
    feed();
    EXPECT_EQ(io.MousePos.x, 40.0F);
    EXPECT_EQ(queue.take_dropped().size(), 2U);
    EXPECT_TRUE(queue.take_dropped().empty());
    feed();
    EXPECT_TRUE(queue.take_dropped().empty());
    EXPECT_EQ(io.MousePos.x, 90.0F);
}

}  // namespace
}  // namespace hanei
