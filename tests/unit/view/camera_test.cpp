#include "ui/view/camera.h"

#include <cmath>
#include <gtest/gtest.h>

namespace hanei {
namespace {

constexpr double aspect = 1.5;
constexpr double rounding = 1e-9;  // coordinates of 10 m after a dozen operations

Camera oblique() {
    Camera camera;
    camera.eye = {-3, -7, 6};
    camera.target = {2, 1, 1};
    camera.field_of_view = 0.7;
    return camera;
}

Bounds office() { return {{0, 0, 0}, {6, 4, 2.8}}; }

double distance_from_ray(const Ray& ray, const Vec3& place) {
    return glm::length(glm::cross(place - ray.origin, ray.direction));
}

TEST(Camera, a_ray_through_the_picture_of_a_place_meets_the_place) {
    for (const bool orthographic : {false, true}) {
        Camera camera = oblique();
        camera.orthographic = orthographic;
        for (const Vec3 place : {Vec3(0, 0, 0), Vec3(6, 4, 2.8), Vec3(1, 3, 0.7), Vec3(-2, 1, 5)}) {
            const auto at = projected(camera, place, aspect);
            ASSERT_TRUE(at);
            EXPECT_LT(distance_from_ray(ray_through(camera, *at, aspect), place), rounding);
        }
    }
}

TEST(Camera, a_place_behind_the_eye_has_no_picture) {
    const Camera camera = oblique();
    EXPECT_FALSE(projected(camera, camera.eye - (camera.target - camera.eye), aspect));
}

TEST(Camera, the_target_is_in_the_middle_and_up_is_up) {
    const Camera camera = oblique();
    EXPECT_LT(glm::length(*projected(camera, camera.target, aspect) - Vec2(0.5)), rounding);
    EXPECT_LT(projected(camera, camera.target + Vec3(0, 0, 0.5), aspect)->y, 0.5);
}

TEST(Camera, the_overview_shows_all_of_a_room_and_fills_the_picture) {
    for (const double wide : {0.7, 1.0, 1.6, 2.4}) {
        const Camera camera = overview(office(), wide);
        Vec2 low(1), high(0);
        for (int k = 0; k < 8; ++k) {
            const Vec3 corner((k & 1) != 0 ? 6 : 0, (k & 2) != 0 ? 4 : 0, (k & 4) != 0 ? 2.8 : 0);
            const auto at = projected(camera, corner, wide);
            ASSERT_TRUE(at);
            low = glm::min(low, *at);
            high = glm::max(high, *at);
        }
        EXPECT_GT(low.x, 0.02);
        EXPECT_GT(low.y, 0.02);
        EXPECT_LT(high.x, 0.98);
        EXPECT_LT(high.y, 0.98);
        EXPECT_GT(std::max(high.x - low.x, high.y - low.y), 0.9);
        EXPECT_GT(camera.eye.z, 2.8) << "a doll's house is looked into from above";
    }
}

TEST(Camera, the_overview_of_nothing_is_still_a_camera) {
    const Camera camera = overview(Bounds{}, 1.5);
    EXPECT_TRUE(std::isfinite(camera.eye.x));
    EXPECT_GT(glm::length(camera.eye - camera.target), 0.1);
}

TEST(Camera, a_plan_has_north_at_the_top_and_east_at_the_right) {
    const Camera camera = plan_view(office(), aspect);
    EXPECT_LT(projected(camera, {3, 4, 0}, aspect)->y, projected(camera, {3, 0, 0}, aspect)->y);
    EXPECT_GT(projected(camera, {6, 2, 0}, aspect)->x, projected(camera, {0, 2, 0}, aspect)->x);
}

TEST(Camera, a_plan_keeps_right_angles_and_scale) {
    const Camera camera = plan_view(office(), aspect);
    const Vec2 corner = *projected(camera, {0, 0, 2.0}, aspect), floor_corner = *projected(camera, {0, 0, 0}, aspect);
    EXPECT_LT(glm::length(corner - floor_corner), rounding) << "walls seen from above are lines";
}

TEST(Camera, orbiting_keeps_the_distance_and_never_passes_the_pole) {
    Camera camera = oblique();
    const double distance = glm::length(camera.eye - camera.target);
    for (int k = 0; k < 50; ++k) {
        camera = orbited(camera, {0.1, 0.3});
        EXPECT_NEAR(glm::length(camera.eye - camera.target), distance, rounding);
        EXPECT_GT(axes_of(camera).up.z, 0.0);
    }
    EXPECT_GT(camera.eye.z - camera.target.z, 0.99 * distance);
}

TEST(Camera, orbiting_out_of_a_plan_starts_with_north_at_the_top) {
    const Camera camera = orbited(plan_view(office(), aspect), {0.0, -0.3});
    EXPECT_LT(camera.eye.y, camera.target.y - 0.1);
    EXPECT_NEAR(camera.eye.x, camera.target.x, rounding);
}

TEST(Camera, panning_moves_the_target_with_the_pointer) {
    const Camera camera = oblique();
    const Camera moved = panned(camera, {0.2, 0.1}, aspect);
    const Vec2 at = *projected(moved, camera.target, aspect);
    EXPECT_NEAR((at.x - 0.5) * aspect, 0.2, rounding);
    EXPECT_NEAR(at.y - 0.5, 0.1, rounding);
}

TEST(Camera, zooming_keeps_what_is_under_the_pointer) {
    for (const bool orthographic : {false, true}) {
        Camera camera = oblique();
        camera.orthographic = orthographic;
        const Vec2 pointer(0.8, 0.3);
        const Ray ray = ray_through(camera, pointer, aspect);
        const Vec3 forward = axes_of(camera).forward;
        const Vec3 under = ray.origin + glm::dot(camera.target - ray.origin, forward) /
                                            glm::dot(ray.direction, forward) * ray.direction;
        const Camera closer = zoomed(camera, 2.0, pointer, aspect);
        EXPECT_LT(glm::length(*projected(closer, under, aspect) - pointer), rounding);
        EXPECT_NEAR(picture_height_at(closer, under), 0.5 * picture_height_at(camera, under), rounding);
    }
}

TEST(Camera, clip_space_agrees_with_projection) {
    for (const bool orthographic : {false, true}) {
        Camera camera = oblique();
        camera.orthographic = orthographic;
        const glm::dmat4 matrix = view_projection(camera, aspect, office());
        for (const Vec3 place : {Vec3(0, 0, 0), Vec3(6, 4, 2.8), Vec3(3, 2, 1)}) {
            const glm::dvec4 clip = matrix * glm::dvec4(place, 1.0);
            const Vec2 at = *projected(camera, place, aspect);
            EXPECT_NEAR(clip.x / clip.w, 2.0 * at.x - 1.0, rounding);
            EXPECT_NEAR(clip.y / clip.w, 1.0 - 2.0 * at.y, rounding);
            EXPECT_LT(std::abs(clip.z / clip.w), 1.0) << "cut off by near or far";
        }
    }
}

TEST(Camera, a_saved_view_gives_the_camera_back) {
    const Camera camera = oblique();
    const View view = view_of(camera, "From the door");
    EXPECT_EQ(view.name, "From the door");
    EXPECT_TRUE(camera_of(view) == camera);
}

}  // namespace
}  // namespace hanei
