#include "ui/view/standpoint.h"

#include <cmath>
#include <gtest/gtest.h>

namespace hanei {
namespace {

constexpr double rounding = 1e-9;  // coordinates of 10 m after a dozen operations
constexpr double aspect = 1.5;

Bounds office() { return {{0, 0, 0}, {6, 4, 2.8}}; }

Vec3 corner(int k) { return {(k & 1) != 0 ? 6.0 : 0.0, (k & 2) != 0 ? 4.0 : 0.0, (k & 4) != 0 ? 2.8 : 0.0}; }

void expect_all_shown(const Camera& camera, double wide, double filled = 0.9) {
    Vec2 low(1), high(0);
    for (int k = 0; k < 8; ++k) {
        const auto at = projected(camera, corner(k), wide);
        ASSERT_TRUE(at);
        low = glm::min(low, *at);
        high = glm::max(high, *at);
    }
    EXPECT_GT(std::min(low.x, low.y), 0.02);
    EXPECT_LT(std::max(high.x, high.y), 0.98);
    EXPECT_GT(std::max(high.x - low.x, high.y - low.y), filled) << "the picture is filled";
}

TEST(Standpoint, every_drawing_shows_all_of_the_room_and_fills_the_picture) {
    for (const Standpoint standpoint : standpoints) {
        for (const double wide : {0.6, 1.0, 2.4}) {
            SCOPED_TRACE(name_of(standpoint));
            expect_all_shown(camera_at(standpoint, office(), wide), wide);
        }
    }
}

TEST(Standpoint, edges_of_a_box_are_straight_across_or_up_every_drawing) {
    for (const Standpoint standpoint : standpoints) {
        if (standpoint == Standpoint::overview) continue;
        const Camera camera = camera_at(standpoint, office(), aspect);
        for (int k = 0; k < 8; ++k) {
            for (const int axis : {1, 2, 4}) {
                const Vec2 along = *projected(camera, corner(k ^ axis), aspect) - *projected(camera, corner(k), aspect);
                EXPECT_LT(std::min(std::abs(along.x), std::abs(along.y)), rounding) << name_of(standpoint);
            }
        }
    }
}

TEST(Standpoint, a_drawing_is_known_by_its_camera_and_lost_by_turning_it) {
    for (const Standpoint standpoint : standpoints) {
        const Camera camera = camera_at(standpoint, office(), aspect);
        const bool drawing = standpoint != Standpoint::overview;
        EXPECT_EQ(standpoint_of(camera).value_or(Standpoint::overview), standpoint);
        EXPECT_EQ(standpoint_of(camera).has_value(), drawing);
        EXPECT_EQ(standpoint_of(zoomed(panned(camera, {0.1, 0.2}, aspect), 1.3, {0.2, 0.8}, aspect)).has_value(),
                  drawing);
        EXPECT_FALSE(standpoint_of(orbited(camera, {0.02, 0.02})));
    }
}

TEST(Standpoint, sides_are_seen_with_their_ends_where_a_person_before_them_has_them) {
    const auto x_of = [](Standpoint standpoint, const Vec3& place) {
        return projected(camera_at(standpoint, office(), aspect), place, aspect)->x;
    };
    EXPECT_LT(x_of(Standpoint::front, {0, 0, 0}), x_of(Standpoint::front, {6, 0, 0}));
    EXPECT_GT(x_of(Standpoint::back, {0, 0, 0}), x_of(Standpoint::back, {6, 0, 0}));
    EXPECT_LT(x_of(Standpoint::right, {6, 0, 0}), x_of(Standpoint::right, {6, 4, 0}));
    EXPECT_GT(x_of(Standpoint::left, {6, 0, 0}), x_of(Standpoint::left, {6, 4, 0}));
}

TEST(Standpoint, a_ceiling_plan_lies_over_the_plan) {
    const Camera plan = camera_at(Standpoint::plan, office(), aspect);
    const Camera ceiling = camera_at(Standpoint::ceiling_plan, office(), aspect);
    for (int k = 0; k < 8; ++k) {
        EXPECT_LT(glm::length(*projected(plan, corner(k), aspect) - *projected(ceiling, corner(k), aspect)), rounding);
    }
    EXPECT_TRUE(is_mirrored(ceiling));
    EXPECT_FALSE(is_mirrored(plan));
}

TEST(Standpoint, rays_and_clip_space_of_a_ceiling_plan_agree_with_its_picture) {
    const Camera camera = camera_at(Standpoint::ceiling_plan, office(), aspect);
    const glm::dmat4 matrix = view_projection(camera, aspect, office());
    for (const Vec3 place : {Vec3(1, 3, 2.8), Vec3(5, 0.5, 0)}) {
        const Vec2 at = *projected(camera, place, aspect);
        const Ray ray = ray_through(camera, at, aspect);
        EXPECT_LT(glm::length(glm::cross(place - ray.origin, ray.direction)), rounding);
        const glm::dvec4 clip = matrix * glm::dvec4(place, 1.0);
        EXPECT_NEAR(clip.x / clip.w, 2.0 * at.x - 1.0, rounding);
        EXPECT_NEAR(clip.y / clip.w, 1.0 - 2.0 * at.y, rounding);
    }
}

TEST(Standpoint, the_other_projection_and_back_gives_the_same_camera_and_keeps_sizes_in_the_middle) {
    for (const Standpoint standpoint : standpoints) {
        const Camera camera = camera_at(standpoint, office(), aspect);
        const Camera other = with_other_projection(camera);
        EXPECT_NE(other.orthographic, camera.orthographic);
        EXPECT_NEAR(picture_height_at(other, other.target), picture_height_at(camera, camera.target), rounding);
        EXPECT_TRUE(with_other_projection(other) == camera);
    }
}

TEST(Standpoint, fitting_keeps_the_direction_and_fills_the_picture_with_any_lens) {
    for (const double field_of_view : {0.01, 0.55, 1.5, 2.6}) {
        for (const bool orthographic : {false, true}) {
            Camera camera;
            camera.eye = {-3, -7, 6};
            camera.target = {2, 1, 1};
            camera.field_of_view = field_of_view;
            camera.orthographic = orthographic;
            const Camera near = fitted(camera, office(), aspect);
            EXPECT_LT(glm::length(axes_of(near).forward - axes_of(camera).forward), rounding);
            const bool stands_off = !orthographic && field_of_view > 1.0;  // no lens goes into a corner of the room
            expect_all_shown(near, aspect, stands_off ? 0.2 : 0.9);
        }
    }
}

}  // namespace
}  // namespace hanei
