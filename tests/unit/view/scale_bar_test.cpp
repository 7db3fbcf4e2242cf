#include "ui/view/scale_bar.h"

#include "ui/view/axis_cross.h"
#include "ui/view/standpoint.h"

#include <cmath>
#include <gtest/gtest.h>

namespace hanei {
namespace {

const Bounds room{{0.0, 0.0, 0.0}, {8.0, 5.0, 3.0}};

/// A plan in which a metre takes so many pixels, 1000 high.
Camera plan_with(double pixels_a_metre) {
    Camera camera = camera_at(Standpoint::plan, room, 1.5);
    const double wished = 1000.0 / pixels_a_metre;
    camera.eye = camera.target + wished / picture_height_at(camera, camera.target) * (camera.eye - camera.target);
    return camera;
}

std::string bar_text(double pixels_a_metre, LengthUnit unit) {
    const auto bar = scale_bar(plan_with(pixels_a_metre), 1000.0, 130.0, unit);
    return bar ? bar->text : "";
}

TEST(ScaleBar, is_the_longest_round_length_that_has_room) {
    EXPECT_EQ(bar_text(100.0, LengthUnit::metre), "1 m");
    EXPECT_EQ(bar_text(65.0, LengthUnit::metre), "2 m") << "exactly 130 pixels";
    EXPECT_EQ(bar_text(66.0, LengthUnit::metre), "1 m");
    EXPECT_EQ(bar_text(20.0, LengthUnit::metre), "5 m");
    EXPECT_EQ(bar_text(13.0, LengthUnit::metre), "10 m");
    EXPECT_EQ(bar_text(300.0, LengthUnit::metre), "0.2 m");
}

TEST(ScaleBar, speaks_the_users_unit) {
    EXPECT_EQ(bar_text(100.0, LengthUnit::centimetre), "100 cm");
    EXPECT_EQ(bar_text(100.0, LengthUnit::millimetre), "1000 mm");
    EXPECT_EQ(bar_text(100.0, LengthUnit::feet_inches), "2 ft");
    EXPECT_EQ(bar_text(20.0, LengthUnit::feet_inches), "20 ft");
    EXPECT_EQ(bar_text(500.0, LengthUnit::feet_inches), "6 in");
    EXPECT_EQ(bar_text(2000.0, LengthUnit::feet_inches), "2 in");
}

TEST(ScaleBar, is_as_long_on_the_screen_as_the_length_in_the_picture) {
    const Camera camera = camera_at(Standpoint::front, room, 1.5);
    const auto bar = scale_bar(camera, 800.0, 130.0, LengthUnit::metre);
    ASSERT_TRUE(bar);
    const Vec3 at{1.0, 0.0, 1.0};
    const Vec2 a = *projected(camera, at, 1.5), b = *projected(camera, at + Vec3(bar->metres, 0.0, 0.0), 1.5);
    EXPECT_NEAR((b.x - a.x) * 1.5 * 800.0, bar->pixels, 1e-6);
    EXPECT_LE(bar->pixels, 130.0);
    EXPECT_GT(bar->pixels, 130.0 / 2.51);
}

TEST(ScaleBar, is_not_in_perspective_nor_where_there_is_no_size) {
    EXPECT_FALSE(scale_bar(camera_at(Standpoint::overview, room, 1.5), 800.0, 130.0, LengthUnit::metre));
    Camera nowhere;
    nowhere.orthographic = true;
    EXPECT_FALSE(scale_bar(nowhere, 800.0, 130.0, LengthUnit::metre));
    EXPECT_FALSE(scale_bar(plan_with(100.0), 1000.0, 0.0, LengthUnit::metre));
}

TEST(AxisCross, lies_as_the_axes_do_in_the_picture) {
    for (const AxisMark& mark : axis_marks(camera_at(Standpoint::plan, room, 1.5))) {
        const double way = mark.ahead ? 1.0 : -1.0;
        const double seen = mark.axis == 0 ? mark.at.x : mark.axis == 1 ? -mark.at.y : -mark.depth;
        EXPECT_NEAR(seen, way, 1e-9) << mark.letter() << ": x to the right, y up, z towards the eye";
    }
    const auto marks = axis_marks(camera_at(Standpoint::overview, room, 1.5));
    for (std::size_t k = 1; k < marks.size(); ++k) EXPECT_GE(marks[k - 1].depth, marks[k].depth - 1e-9);
}

}  // namespace
}  // namespace hanei
