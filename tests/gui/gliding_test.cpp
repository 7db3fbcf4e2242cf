#include "bare_desk.h"
#include "computer_room.h"
#include "ui/view/standpoint.h"

#include <imgui.h>

namespace hanei {
namespace {

class Gliding : public testing::Test {
protected:
    void open(bool glides, bool repeatable) {
        ProjectDoor door;
        door.user.open_preferences = [glides] {
            UserDoor::Opened opened;
            opened.preferences.glides = glides;
            return opened;
        };
        desk = std::make_unique<BareDesk>(computer_room().content, door, ImVec2{1280.0F, 800.0F},
                                          Workbench::Options{repeatable});
        for (int k = 0; k < 30; ++k) desk->frame();  // the first view has arrived
    }
    void press(Key key) {
        desk->input().key(key, true);
        desk->input().key(key, false);
        desk->run_queue();
    }
    const Viewport& viewport() const { return desk->workbench().viewport(); }
    const Camera& camera() const { return viewport().state.camera; }
    const Camera& shown() const { return viewport().state.panes.active_pane().camera; }

    std::unique_ptr<BareDesk> desk;
};

TEST_F(Gliding, the_picture_is_on_its_way_for_a_quarter_of_a_second_and_everything_else_is_there) {
    open(true, false);
    press(key_of('P'));
    EXPECT_EQ(standpoint_of(camera()), Standpoint::plan);
    EXPECT_FALSE(standpoint_of(shown()));
    EXPECT_TRUE(viewport().goes_on()) << "frames are due";
    for (int k = 0; k < 16; ++k) desk->frame();  // 0.27 s
    EXPECT_TRUE(shown() == camera());
    EXPECT_FALSE(viewport().goes_on());
}

TEST_F(Gliding, what_is_done_meanwhile_is_done_to_the_picture_at_its_end) {
    open(true, false);
    press(key_of('P'));
    const double before = picture_height_at(camera(), camera().target);
    desk->input().mouse_move(600.0F, 300.0F);
    desk->input().wheel(2.0F);
    desk->run_queue();
    EXPECT_TRUE(shown() == camera());
    EXPECT_EQ(standpoint_of(camera()), Standpoint::plan);
    EXPECT_LT(picture_height_at(camera(), camera().target), 0.8 * before);
}

TEST_F(Gliding, another_view_on_the_way_is_gone_to_from_where_the_picture_is) {
    open(true, false);
    press(key_of('P'));
    desk->frame();
    const auto corner = [&] { return projected(shown(), Vec3(0.0), viewport().aspect()).value(); };
    const Vec2 underway = corner();
    press(Key::keypad_1);
    EXPECT_LT(glm::distance(underway, corner()), 0.15) << "no jump";  // of the picture, in three frames
    EXPECT_FALSE(shown() == camera());
    for (int k = 0; k < 20; ++k) desk->frame();
    EXPECT_TRUE(shown() == camera());
}

TEST_F(Gliding, who_does_not_like_it_is_there_at_once_and_so_are_scripts) {
    for (const bool repeatable : {false, true}) {
        open(repeatable, repeatable);
        press(key_of('P'));
        EXPECT_TRUE(shown() == camera());
        EXPECT_EQ(standpoint_of(shown()), Standpoint::plan);
    }
}

}  // namespace
}  // namespace hanei
