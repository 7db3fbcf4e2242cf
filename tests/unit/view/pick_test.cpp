#include "ui/view/pick.h"

#include "room_by_hand.h"
#include "ui/view/cell_field.h"
#include "ui/view/isolux_labels.h"

#include <cmath>
#include <gtest/gtest.h>

namespace hanei {
namespace {

using test::furnished_room;
using test::solution_by_hand;

constexpr double aspect = 1.5;

Vec2 picture_of(const Camera& camera, const Vec3& place) { return projected(camera, place, aspect).value(); }

test::Light plane_field(const Vec3& place, const Vec3&) { return {100.0 * place.x, 10.0 * place.y + place.z, 7.0}; }

TEST(Hit, reads_the_light_where_the_ray_meets_the_floor) {
    const auto solution = solution_by_hand(furnished_room(), plane_field);
    const Ray down{{3.1, 1.07, 9.0}, {0, 0, -1}};
    const auto found = hit(*solution, down);
    ASSERT_TRUE(found);
    EXPECT_NEAR(found->place.z, 0.0, 1e-12);
    EXPECT_EQ(found->surface.face, Room::floor_face);
    EXPECT_NEAR(found->direct, 310.0, 1e-4);  // linear field, values stored as float
    EXPECT_NEAR(found->interreflected, 10.7, 1e-5);
    EXPECT_NEAR(found->unshadowed, 7.0, 1e-6);
    EXPECT_NEAR(found->distance, 9.0, 1e-12);
}

TEST(Hit, takes_the_desk_before_the_floor_and_looks_through_the_ceilings_back) {
    const auto solution = solution_by_hand(furnished_room(), plane_field);
    const auto found = hit(*solution, {{1.6, 2.2, 9.0}, {0, 0, -1}});
    ASSERT_TRUE(found);
    EXPECT_NEAR(found->place.z, 0.74, 1e-9);
    EXPECT_EQ(found->surface.object, solution->scene->furniture.front().id);
}

TEST(Hit, finds_nothing_beside_the_room_and_in_an_empty_solution) {
    const auto solution = solution_by_hand(furnished_room(), plane_field);
    EXPECT_FALSE(hit(*solution, {{50, 50, 9}, {0, 0, -1}}));
    EXPECT_FALSE(hit(Solution{}, {{3, 1, 9}, {0, 0, -1}}));
}

TEST(CellField, inverts_the_bilinear_map_of_any_convex_cell) {
    CellFrame frame;
    for (const std::array<Vec2, 4>& corners :
         {std::array<Vec2, 4>{Vec2(0), {2, 0}, {2, 1}, {0, 1}}, std::array<Vec2, 4>{Vec2(0), {2, 0}, {3, 1}, {1, 1}},
          std::array<Vec2, 4>{Vec2(0), {2, 0}, {1.5, 1}, {0.2, 0.7}},
          std::array<Vec2, 4>{Vec2(0), {1, 0}, {3, 3}, {0, 1}},
          std::array<Vec2, 4>{Vec2(0), {1, 0}, {0.6, 0.6}, {0, 1}}}) {
        frame.corner = corners;
        for (double u = 0.0; u <= 1.0; u += 0.125) {
            for (double v = 0.0; v <= 1.0; v += 0.125) {
                const Vec2 place = (1 - u) * (1 - v) * corners[0] + u * (1 - v) * corners[1] + u * v * corners[2] +
                                   (1 - u) * v * corners[3];
                EXPECT_LT(glm::length(bilinear_coordinates(frame, place) - Vec2(u, v)), 1e-9);  // rounding
            }
        }
    }
}

TEST(Pick, names_furniture_under_the_pointer) {
    const Scene scene = furnished_room();
    const Camera camera = overview(bounds_of(scene), aspect);
    EXPECT_EQ(pick(scene, camera, picture_of(camera, {1.6, 2.3, 0.74}), aspect), scene.furniture[0].id);
    EXPECT_EQ(pick(scene, camera, picture_of(camera, {4.2, 2.3, 0.74}), aspect), scene.furniture[1].id);
    EXPECT_EQ(pick(scene, camera, picture_of(camera, {3.0, 0.2, 0.0}), aspect), ObjectId{}) << "bare floor";
    EXPECT_EQ(pick(scene, camera, {0.01, 0.01}, aspect), ObjectId{}) << "background";
}

TEST(Pick, names_luminaires_seen_from_above_and_from_below) {
    const Scene scene = furnished_room();
    const Camera above = overview(bounds_of(scene), aspect);
    EXPECT_EQ(pick(scene, above, picture_of(above, {1.6, 2.0, 2.75}), aspect), scene.luminaires[0].id);
    Camera inside;
    inside.eye = {0.5, 0.5, 1.2};
    inside.target = {4.3, 2.0, 2.75};
    EXPECT_EQ(pick(scene, inside, {0.5, 0.5}, aspect), scene.luminaires[1].id);
}

TEST(Pick, catches_small_luminaires_a_few_pixels_around) {
    const Scene scene = furnished_room();
    const Camera camera = overview(bounds_of(scene), aspect);
    const Vec2 point = picture_of(camera, {3.0, 0.7, 2.0});
    EXPECT_EQ(pick(scene, camera, point + Vec2(0.004, 0.004), aspect), scene.luminaires[3].id);
    EXPECT_NE(pick(scene, camera, point + Vec2(0.03, 0.03), aspect), scene.luminaires[3].id);
    const Vec2 tube = picture_of(camera, {1.0, 3.7, 2.2});
    EXPECT_EQ(pick(scene, camera, tube + Vec2(0.0, 0.005), aspect), scene.luminaires[2].id);
}

TEST(Pick, does_not_reach_through_the_wall_it_shows) {
    Scene scene = furnished_room();
    scene.luminaires[3].position = {3.0, 9.0, 1.0};  // outside, behind the wall at y = 4
    Camera camera;
    camera.eye = {3.0, -6.0, 2.0};
    camera.target = {3.0, 4.0, 1.2};
    EXPECT_EQ(pick(scene, camera, picture_of(camera, {3.0, 9.0, 1.0}), aspect), ObjectId{});
}

TEST(IsoluxLabels, lie_on_their_lines_and_never_over_each_other) {
    const auto solution = solution_by_hand(furnished_room(), test::pleasant_light);
    const PixelSize size{1200, 800};
    const Camera camera = overview(bounds_of(*solution->scene), size.aspect());
    ViewOptions view;
    view.range = suggested_range(*solution);
    const std::vector<IsoluxLabel> labels = isolux_labels(*solution, camera, view, size);
    ASSERT_GT(labels.size(), 5U);
    for (std::size_t k = 0; k < labels.size(); ++k) {
        const auto below = hit(*solution, ray_through(camera, labels[k].at, size.aspect()));
        ASSERT_TRUE(below);
        // Half a pixel of the 300-row buffer: lines are 2 to 3 % of lux a buffer pixel apart here.
        EXPECT_NEAR(below->total() / labels[k].lux, 1.0, 0.04) << labels[k].text;
        for (std::size_t other = 0; other < k; ++other) {
            const Vec2 apart = glm::abs(labels[k].at - labels[other].at) * Vec2(size.width, size.height);
            EXPECT_TRUE(apart.x > 24.0 || apart.y > 13.0) << labels[k].text << " over " << labels[other].text;
        }
    }
}

TEST(IsoluxLabels, stay_while_their_lines_do_and_go_when_those_go) {
    const auto solution = solution_by_hand(furnished_room(), test::pleasant_light);
    const PixelSize size{1200, 800};
    const Camera camera = overview(bounds_of(*solution->scene), size.aspect());
    ViewOptions view;
    view.range = suggested_range(*solution);
    const std::vector<IsoluxLabel> labels = isolux_labels(*solution, camera, view, size);
    EXPECT_EQ(labels_that_hold(labels, *solution, camera, view, size).size(), labels.size());
    const auto brighter = solution_by_hand(furnished_room(), [](const Vec3& place, const Vec3& normal) {
        test::Light light = test::pleasant_light(place, normal);
        light.direct *= 1.3;
        light.interreflected *= 1.3;
        return light;
    });
    EXPECT_LT(labels_that_hold(labels, *brighter, camera, view, size).size(), labels.size() / 3);
    EXPECT_TRUE(labels_that_hold(labels, Solution{}, camera, view, size).empty());
}

TEST(IsoluxLabels, are_absent_without_lines_in_photos_and_without_values) {
    const auto solution = solution_by_hand(furnished_room(), test::pleasant_light);
    const PixelSize size{600, 400};
    const Camera camera = overview(bounds_of(*solution->scene), size.aspect());
    ViewOptions view;
    view.isolux = false;
    EXPECT_TRUE(isolux_labels(*solution, camera, view, size).empty());
    view = {};
    view.scale = Scale::photo;
    EXPECT_TRUE(isolux_labels(*solution, camera, view, size).empty());
    EXPECT_TRUE(isolux_labels(Solution{}, camera, ViewOptions{}, size).empty());
}

}  // namespace
}  // namespace hanei
