#include "ui/view/left_out.h"

#include "room_by_hand.h"
#include "ui/view/pick.h"
#include "ui/view/sight.h"
#include "ui/view/standpoint.h"
#include "ui/view/value_buffer.h"

#include <cmath>
#include <gtest/gtest.h>

namespace hanei {
namespace {

using test::furnished_room;
using test::pleasant_light;
using test::solution_by_hand;

constexpr Vec3 down{0.0, 0.0, -1.0};

LeftOut above(double z) { return {false, Cut{{0.0, 0.0, 1.0}, z}}; }

double area_of(const Polygon& polygon) { return glm::length(vector_area(polygon)); }

TEST(LeftOut, a_level_cut_through_a_desk_shows_its_two_legs_in_their_size) {
    Scene scene = furnished_room();
    scene.furniture.resize(1);
    const std::vector<Polygon> sections = sections_of(scene, Cut{{0, 0, 1}, 0.4});
    ASSERT_EQ(sections.size(), 2U);
    for (const Polygon& section : sections) {
        EXPECT_NEAR(area_of(section), 0.04 * 0.7, 1e-12);
        for (const Vec3& corner : section) EXPECT_NEAR(corner.z, 0.4, 1e-12);
    }
    EXPECT_TRUE(sections_of(scene, Cut{{0, 0, 1}, 1.5}).empty()) << "above the desk";
    EXPECT_TRUE(sections_of(scene, Cut{{0, 0, 1}, -1.0}).empty());
}

TEST(LeftOut, a_cut_room_has_lines_around_its_plan) {
    double length = 0.0;
    for (const auto& [from, to] : cut_lines_of(furnished_room(), Cut{{0, 0, 1}, 1.2}))
        length += glm::distance(from, to);
    EXPECT_NEAR(length, 2.0 * (6.0 + 4.0), 1e-9);
}

TEST(LeftOut, a_ray_meets_nothing_before_the_plane_and_nothing_within_what_is_cut) {
    const auto solution = solution_by_hand(furnished_room(), pleasant_light);
    const Vec3 over_the_desk{1.6, 2.2, 9.0};
    ASSERT_NEAR(hit(*solution, {over_the_desk, down})->place.z, 0.74, 1e-9);
    EXPECT_NEAR(hit(*solution, {over_the_desk, down, above(0.5)})->place.z, 0.0, 1e-9) << "the top is left out";
    EXPECT_FALSE(hit(*solution, {over_the_desk, down, above(0.72)})) << "within the top";
    EXPECT_NEAR(hit(*solution, {over_the_desk, down, above(0.74)})->place.z, 0.74, 1e-9) << "in its face";
    EXPECT_FALSE(hit(*solution, {over_the_desk, down, above(-0.1)}));
}

TEST(LeftOut, a_ceiling_that_is_taken_off_is_looked_through_from_below) {
    const auto solution = solution_by_hand(furnished_room(), pleasant_light);
    const Ray up{{5.5, 0.2, 1.6}, -down};
    ASSERT_TRUE(hit(*solution, up));
    EXPECT_FALSE(hit(*solution, {up.origin, up.direction, {true, std::nullopt}}));
    EXPECT_FALSE(first_face(*solution->scene, {up.origin, up.direction, {true, std::nullopt}}));
}

TEST(LeftOut, luminaires_stay_without_the_ceiling_and_go_with_a_section) {
    const Scene scene = furnished_room();
    Camera camera = camera_at(Standpoint::plan, bounds_of(scene), 1.5);
    const Luminaire& lamp = scene.luminaires.front();
    const Vec2 at = *projected(camera, lamp.position, 1.5);
    ASSERT_EQ(pick(scene, camera, at, 1.5), lamp.id);
    camera.left_out.ceiling = true;
    EXPECT_EQ(pick(scene, camera, at, 1.5), lamp.id);
    camera.left_out = above(lamp.position.z - 0.1);
    EXPECT_NE(pick(scene, camera, at, 1.5), lamp.id);
}

TEST(LeftOut, picking_the_exact_picture_and_the_figures_leave_out_the_same) {
    const auto solution = solution_by_hand(furnished_room(), pleasant_light);
    const PixelSize size{60, 40};
    for (const Standpoint standpoint : {Standpoint::overview, Standpoint::plan, Standpoint::front}) {
        Camera camera = camera_at(standpoint, bounds_of(*solution->scene), size.aspect());
        camera.left_out = {true, Cut{glm::normalize(Vec3(0.2, -1.0, 0.3)), -1.1}};
        const ValueBuffer buffer = value_buffer(*solution, camera, ViewOptions{}, size);
        const Sight sight(*solution, camera, size.aspect());
        const CutPlanes planes(camera.left_out, solution->scene.get());
        int seen_by_both = 0;
        for (int y = 0; y < size.height; ++y) {
            for (int x = 0; x < size.width; ++x) {
                const Vec2 at((x + 0.5) / size.width, (y + 0.5) / size.height);
                const auto met = hit(*solution, ray_through(camera, at, size.aspect()));
                const auto seen = sight.through(at);
                EXPECT_TRUE(!seen || planes.keeps(seen->place));
                if (!met) continue;
                EXPECT_TRUE(planes.keeps(met->place));
                ASSERT_TRUE(seen);
                EXPECT_LT(glm::distance(seen->place, met->place), 1e-6);
                if (buffer.face[buffer.at(x, y)] < 0) continue;  // a luminaire before it
                EXPECT_EQ(buffer.face[buffer.at(x, y)], static_cast<int>(met->face));
                ++seen_by_both;
            }
        }
        EXPECT_GT(seen_by_both, 100) << name_of(standpoint);
    }
}

TEST(LeftOut, a_saved_view_keeps_it) {
    Camera camera = camera_at(Standpoint::plan, {{0, 0, 0}, {6, 4, 2.8}}, 1.5);
    camera.left_out = {true, Cut{{1, 0, 0}, 2.5}};
    EXPECT_TRUE(camera_of(view_of(camera, "Section")) == camera);
}

}  // namespace
}  // namespace hanei
