#include "ui/panels/pane_set.h"

#include <gtest/gtest.h>

namespace hanei {
namespace {

const ScreenRect screen{100.0F, 50.0F, 900.0F, 650.0F};
const Bounds office{{0, 0, 0}, {6, 4, 2.8}};

class Panes : public testing::Test {
protected:
    Panes() {
        panes.lay_out(screen, camera);
        panes.look_from(Standpoint::overview, camera, office, 0.0F);
        show();
    }

    PaneSet::Present present() { return {camera, part}; }

    void show() {
        panes.lay_out(screen, camera);
        panes.follow_shapes(camera, office, 0.0F);
        panes.lay_out(screen, camera);
    }

    void choose(PaneLayout layout) {
        panes.choose(layout, present(), office);
        show();
    }

    std::optional<Standpoint> drawing(int k) const { return standpoint_of(panes.camera(k, camera)); }

    PaneSet panes;
    Camera camera;
    LightPart part = LightPart::total;
};

TEST_F(Panes, four_are_plan_perspective_front_and_side_and_the_perspective_is_the_present_one) {
    const Camera before = camera;
    choose(PaneLayout::four);
    EXPECT_EQ(panes.count(), 4);
    EXPECT_EQ(drawing(0), Standpoint::plan);
    EXPECT_FALSE(drawing(1));
    EXPECT_EQ(drawing(2), Standpoint::front);
    EXPECT_EQ(drawing(3), Standpoint::right);
    EXPECT_EQ(panes.active(), 1);
    EXPECT_LT(glm::length(axes_of(camera).forward - axes_of(before).forward), 1e-9) << "fitted to its new shape";
}

TEST_F(Panes, every_picture_shows_all_of_the_room_in_its_own_shape) {
    panes.divider = {0.3, 0.7};
    choose(PaneLayout::four);
    for (int k = 0; k < 4; ++k) {
        const Pane& pane = panes.pane(k);
        for (int c = 0; c < 8; ++c) {
            const Vec3 corner((c & 1) != 0 ? 6 : 0, (c & 2) != 0 ? 4 : 0, (c & 4) != 0 ? 2.8 : 0);
            const auto at = pane.on_screen(corner);
            ASSERT_TRUE(at);
            EXPECT_TRUE(pane.holds(*at)) << "picture " << k;
        }
    }
}

TEST_F(Panes, pictures_fill_the_rectangle_and_do_not_overlap) {
    for (const PaneLayout layout : {PaneLayout::split, PaneLayout::four, PaneLayout::four_parts}) {
        choose(layout);
        float area = 0.0F;
        for (int k = 0; k < panes.count(); ++k) {
            const Pane& pane = panes.pane(k);
            area += pane.width * pane.height;
            EXPECT_GE(pane.left, screen.left);
            EXPECT_GE(pane.top, screen.top);
            EXPECT_LE(pane.left + pane.width, screen.right);
            EXPECT_LE(pane.top + pane.height, screen.bottom);
            EXPECT_EQ(panes.under({pane.left + 0.5F * pane.width, pane.top + 0.5F * pane.height}), k);
        }
        EXPECT_GT(area, 0.98F * 800.0F * 600.0F) << "all but the gaps";
        EXPECT_FALSE(panes.under({10.0F, 10.0F}));
    }
}

TEST_F(Panes, each_keeps_its_camera_and_its_light_while_another_is_active) {
    choose(PaneLayout::split);
    part = LightPart::direct;
    const Camera left = camera;
    panes.activate(1, present());
    EXPECT_EQ(standpoint_of(camera), Standpoint::plan);
    EXPECT_EQ(part, LightPart::total);
    EXPECT_TRUE(panes.camera(0, camera) == left);
    EXPECT_EQ(panes.part(0, part), LightPart::direct);
    EXPECT_TRUE(panes.shows(LightPart::direct, part));
    EXPECT_FALSE(panes.shows(LightPart::unshadowed, part));
    panes.activate(0, present());
    EXPECT_TRUE(camera == left);
    EXPECT_EQ(part, LightPart::direct);
}

TEST_F(Panes, the_active_one_fills_the_view_alone_and_steps_back_into_its_place) {
    choose(PaneLayout::four);
    panes.activate(2, present());
    choose(PaneLayout::single);
    EXPECT_EQ(standpoint_of(camera), Standpoint::front);
    EXPECT_EQ(panes.pane(0).width, 800.0F);
    camera = zoomed(camera, 2.0, {0.5, 0.5}, 1.0);
    const Camera closer = camera;
    choose(PaneLayout::four);
    EXPECT_EQ(panes.active(), 2);
    EXPECT_TRUE(camera == closer);
    EXPECT_EQ(drawing(0), Standpoint::plan);
}

TEST_F(Panes, four_parts_look_through_one_camera_and_leave_the_layout_as_it_was) {
    choose(PaneLayout::split);
    const Camera before = camera;
    panes.toggle(PaneLayout::four_parts, present(), office);
    for (int k = 0; k < 4; ++k) EXPECT_TRUE(panes.camera(k, camera) == before);
    EXPECT_EQ(panes.part(3, part), LightPart::interreflected);
    EXPECT_TRUE(panes.shows(LightPart::unshadowed, part));
    panes.toggle(PaneLayout::four_parts, present(), office);
    EXPECT_EQ(panes.layout(), PaneLayout::split);
    EXPECT_EQ(drawing(1), Standpoint::plan);
    panes.toggle(PaneLayout::split, present(), office);
    EXPECT_EQ(panes.layout(), PaneLayout::single);
}

TEST_F(Panes, a_camera_that_was_moved_by_hand_is_left_alone_when_the_shape_changes) {
    camera = orbited(camera, {0.1, 0.0});
    const Camera turned = camera;
    choose(PaneLayout::split);
    EXPECT_TRUE(camera == turned);
}

}  // namespace
}  // namespace hanei
