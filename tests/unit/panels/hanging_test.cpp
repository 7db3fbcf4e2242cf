#include "ui/panels/hanging.h"

#include "engine/edit/edit.h"

#include <gtest/gtest.h>

namespace hanei {
namespace {

Ray down_at(double x, double y) { return {{x, y, 9.0}, {0.0, 0.0, -1.0}}; }

TEST(APlaceInThePlan, is_below_the_pointer_and_on_the_raster) {
    const Vec2 place = place_in_plan(empty_room(), down_at(1.234, 2.345), 0.1);
    EXPECT_NEAR(place.x, 1.2, 1e-12);  // rounding of the raster
    EXPECT_NEAR(place.y, 2.3, 1e-12);
    EXPECT_EQ(place_in_plan(empty_room(), down_at(1.234, 2.345), 0.0), Vec2(1.234, 2.345));
}

TEST(APlaceInThePlan, keeps_off_the_wall_that_is_pointed_at) {
    const Ray at_wall{{3.0, 2.0, 1.5}, {1.0, 0.0, 0.0}};
    EXPECT_NEAR(place_in_plan(empty_room(), at_wall, 0.1).x, 5.7, 1e-12);  // 0.3 m off the wall at 6 m
}

TEST(APlaceInThePlan, is_the_middle_of_the_room_when_nothing_is_pointed_at) {
    EXPECT_EQ(place_in_plan(empty_room(), {}, 0.1), Vec2(3.0, 2.0));
    const Ray at_the_sky{{3.0, 2.0, 9.0}, {0.0, 0.0, 1.0}};
    EXPECT_EQ(place_in_plan(empty_room(), at_the_sky, 0.1), Vec2(3.0, 2.0));
    EXPECT_EQ(place_in_plan(Scene{}, down_at(1.0, 1.0), 0.1), Vec2(3.0, 2.0));
}

}  // namespace
}  // namespace hanei
