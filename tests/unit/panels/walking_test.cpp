#include "ui/panels/walking.h"

#include "engine/edit/edit.h"
#include "engine/edit/plan_shape.h"

#include <gtest/gtest.h>
#include <numbers>

namespace hanei {
namespace {

Scene room_of(std::vector<Vec2> plan) {
    Scene scene = empty_room();
    scene.room->plan = std::move(plan);
    scene.room->wall_materials.resize(scene.room->plan.size(), scene.room->wall_materials.front());
    return scene;
}

Scene six_by_four() { return room_of({{0.0, 0.0}, {6.0, 0.0}, {6.0, 4.0}, {0.0, 4.0}}); }
/// Without the quarter beyond (3, 2).
Scene l_shaped() { return room_of({{0.0, 0.0}, {6.0, 0.0}, {6.0, 2.0}, {3.0, 2.0}, {3.0, 4.0}, {0.0, 4.0}}); }

TEST(Walking, a_step_in_the_open_is_taken_as_it_is_wished) {
    const Step step = stepped(six_by_four(), {2.0, 2.0}, {0.5, -0.25});
    EXPECT_NEAR(glm::distance(step.place, Vec2(2.5, 1.75)), 0.0, 1e-12);  // rounding of the parts' sum
    EXPECT_FALSE(step.is_held);
}

TEST(Walking, a_wall_holds_a_step_a_shoulder_before_it) {
    const Step step = stepped(six_by_four(), {5.0, 2.0}, {3.0, 0.0});
    EXPECT_NEAR(step.place.x, 5.75, 1e-6);
    EXPECT_NEAR(step.place.y, 2.0, 1e-9);
    EXPECT_TRUE(step.is_held);
}

TEST(Walking, a_slanting_step_slides_along_the_wall) {
    const Step step = stepped(six_by_four(), {2.0, 3.7}, {1.0, 0.5});
    EXPECT_NEAR(step.place.x, 3.0, 1e-6);
    EXPECT_NEAR(step.place.y, 3.75, 1e-6);
    EXPECT_FALSE(step.is_held) << "most of it was gone";
}

TEST(Walking, a_corner_that_juts_out_is_walked_around) {
    const Scene scene = l_shaped();
    Vec2 at(2.5, 3.0);
    for (int k = 0; k < 200; ++k) at = stepped(scene, at, {0.02, -0.02}).place;
    EXPECT_GT(at.x, 4.5);
    EXPECT_LT(at.y, 1.75 + 1e-6);
}

TEST(Walking, no_step_however_long_leaves_the_room) {
    const Scene scene = l_shaped();
    for (int k = 0; k < 64; ++k) {
        const double angle = 2.0 * std::numbers::pi * k / 64.0;
        for (const double length : {0.01, 0.3, 5.0, 1e4}) {
            const Step step = stepped(scene, {1.0, 1.0}, length * Vec2(std::cos(angle), std::sin(angle)));
            EXPECT_TRUE(plan_holds(scene.room->plan, step.place)) << k << " " << length;
        }
    }
}

TEST(Walking, the_way_is_the_same_at_sixty_and_at_fifteen_frames_a_second) {
    const Scene scene = l_shaped();
    Vec2 often(1.0, 2.0), seldom(1.0, 2.0);
    for (int k = 0; k < 120; ++k) often = stepped(scene, often, Vec2(1.4, -0.7) / 60.0).place;
    for (int k = 0; k < 30; ++k) seldom = stepped(scene, seldom, Vec2(1.4, -0.7) / 15.0).place;
    EXPECT_NEAR(glm::distance(often, seldom), 0.0, 0.02);  // m: where a wall is met within a step
}

TEST(Walking, in_a_passage_narrower_than_two_shoulders_one_still_gets_ahead) {
    const Scene scene = room_of({{0.0, 0.0}, {5.0, 0.0}, {5.0, 0.3}, {0.0, 0.3}});
    const Step step = stepped(scene, {1.0, 0.15}, {1.0, 0.0});
    EXPECT_NEAR(step.place.x, 2.0, 1e-6);
}

TEST(Walking, from_outside_nothing_holds_and_no_figure_is_not_a_step) {
    EXPECT_EQ(stepped(six_by_four(), {-3.0, 2.0}, {1.0, 0.0}).place, Vec2(-2.0, 2.0));
    EXPECT_EQ(stepped(six_by_four(), {2.0, 2.0}, {std::nan(""), 0.0}).place, Vec2(2.0, 2.0));
    EXPECT_EQ(stepped(six_by_four(), {2.0, 2.0}, {0.0, 0.0}).place, Vec2(2.0, 2.0));
}

TEST(Walking, who_looks_in_from_outside_enters_upright_and_faces_the_middle) {
    const Scene scene = l_shaped();
    const Walker walker = entering(scene, overview(bounds_of(scene), 1.5));
    EXPECT_TRUE(plan_holds(scene.room->plan, Vec2(walker.eye)));
    EXPECT_EQ(walker.eye.z, 1.6);
    EXPECT_EQ(walker.pitch, 0.0);
    const Vec2 to_middle = middle_of_plan(scene.room->plan) - Vec2(walker.eye);
    EXPECT_GT(glm::dot(to_middle, Vec2(std::cos(walker.heading), std::sin(walker.heading))),
              0.999 * glm::length(to_middle));
}

TEST(Walking, who_stands_in_the_room_already_keeps_place_and_gaze) {
    Camera camera;
    camera.eye = {2.0, 1.0, 2.2};
    camera.target = {4.0, 3.0, 1.2};
    const Walker walker = entering(six_by_four(), camera);
    EXPECT_EQ(Vec2(walker.eye), Vec2(2.0, 1.0));
    EXPECT_EQ(walker.eye.z, 1.6);
    EXPECT_NEAR(walker.heading, 0.25 * std::numbers::pi, 1e-12);
    EXPECT_LT(walker.pitch, -0.3);
}

TEST(Walking, looking_up_and_down_ends_before_the_picture_would_turn_over) {
    Walker walker;
    walker.turn(0.3, 10.0);
    const Camera up = seen_by(walker, Camera{});
    walker.turn(0.0, -20.0);
    const Camera down = seen_by(walker, Camera{});
    for (const Camera& camera : {up, down}) {
        EXPECT_GT(axes_of(camera).up.z, 0.1) << "the head is up";
        EXPECT_NEAR(walker_of(camera).heading, 0.3, 1e-9);
    }
}

TEST(Walking, a_low_room_lowers_the_eye) {
    Scene scene = six_by_four();
    scene.room->height = 1.2;
    EXPECT_NEAR(entering(scene, overview(bounds_of(scene), 1.5)).eye.z, 1.1, 1e-12);
    scene.room->height = 0.2;
    EXPECT_NEAR(entering(scene, overview(bounds_of(scene), 1.5)).eye.z, 0.1, 1e-12);
}

}  // namespace
}  // namespace hanei
