/// Rooms whose answer is known on paper, through the same door as every other room.
#include "engine/study/study.h"
#include "tests/box_room.h"

#include <cmath>
#include <gtest/gtest.h>
#include <numbers>

namespace hanei {
namespace {

SolutionSnapshot solve(const Scene& scene, double max_patch, Method method = Method::patch) {
    Settings settings;
    settings.max_patch = max_patch;
    settings.accuracy = 1e-9;
    settings.bounces = 100'000;
    settings.method = method;
    return Study().run(std::make_shared<const Scene>(scene), settings, StudyRequest{}, Work{});
}

/// The room's faces as free surfaces that all emit by themselves.
Scene furnace(const Scene& room, double reflectance, double own_exitance) {
    Scene scene;
    scene.materials.push_back({scene.new_id(), "wall", reflectance, {}});
    for (const Face& face : faces_of(room))
        scene.surfaces.push_back({scene.new_id(), "face", face.region, scene.materials.front().id, {own_exitance}, {}});
    return scene;
}

TEST(ClosedRoom, a_closed_room_of_reflectance_one_half_doubles_the_emitted_exitance) {
    Scene scene = furnace(test::box_room({3.0, 2.0, 2.5}, 0.5), 0.5, 100.0);
    for (const Vec3& place : {Vec3{1.5, 1.0, 0.0}, Vec3{0.0, 0.0, 0.0}, Vec3{1.0, 0.0, 0.0}})
        scene.points.push_back(test::point(scene, place));
    const auto solution = solve(scene, 0.5);
    for (const PointResult& point : solution->points)
        EXPECT_NEAR(point.value.total().value, 200.0, 200.0 * 2e-6);  // form factors are kept as floats
}

TEST(ClosedRoom, furniture_changes_nothing_in_a_furnace) {
    Scene room = test::box_room({3.0, 2.0, 2.5}, 0.5);
    room.furniture.push_back(test::box(room, {1.2, 0.9, 0.0}, {0.6, 0.5, 0.8}));
    room.furniture.back().rotation = 0.4;
    Scene scene = furnace(room, 0.5, 100.0);
    for (const Vec3& place : {Vec3{2.5, 1.0, 0.0}, Vec3{1.2, 0.9, 0.8}, Vec3{0.1, 0.1, 0.0}})
        scene.points.push_back(test::point(scene, place));
    const auto solution = solve(scene, 0.5);
    for (const PointResult& point : solution->points)
        EXPECT_NEAR(point.value.total().value, 200.0,
                    200.0 * 1e-4);  // of visible shares kept as floats, many of them partial
}

TEST(ClosedRoom, the_mean_illuminance_is_the_flux_over_what_is_absorbed) {
    for (const double reflectance : {0.2, 0.5, 0.8}) {
        Scene scene = test::box_room({4.0, 3.0, 2.5}, reflectance);
        scene.luminaires.push_back(test::point_source(scene, {2.0, 1.5, 1.25}, 5000.0));
        const double surface = 2.0 * (4.0 * 3.0 + 4.0 * 2.5 + 3.0 * 2.5);
        const double expected = 5000.0 / (surface * (1.0 - reflectance));  // energy balance, CIE 171:2006 case 5.8
        EXPECT_NEAR(mean_illuminance(*solve(scene, 0.4)), expected, 0.005 * expected);  // patch width 0.4 m
    }
}

TEST(ClosedRoom, doubling_the_distance_to_a_point_source_quarters_the_illuminance) {
    Scene scene = test::box_room({10.0, 10.0, 10.0}, 0.0);
    scene.luminaires.push_back(test::point_source(scene, {5.0, 5.0, 9.0}, 1000.0));
    scene.points = {test::point(scene, {5.0, 5.0, 8.0}), test::point(scene, {5.0, 5.0, 7.0})};
    const auto solution = solve(scene, 2.0);
    const double near = solution->points[0].value.total().value;
    EXPECT_NEAR(near, 1000.0 / (4.0 * std::numbers::pi), 1e-9);
    EXPECT_NEAR(solution->points[1].value.total().value, near / 4.0, 1e-9);
}

TEST(ClosedRoom, a_luminous_ceiling_agrees_with_the_zonal_cavity_method) {
    // Square room of room index 1, reflectances 70/50/20, flux spread over the whole ceiling: the
    // three-surface algebra gives a utilisation factor of 0.604.
    Scene scene = test::box_room({4.0, 4.0, 2.0}, 0.5);
    scene.materials.push_back({scene.new_id(), "ceiling", 0.7, {}});
    scene.room->ceiling_material = scene.materials.back().id;
    scene.materials.push_back({scene.new_id(), "floor", 0.2, {}});
    scene.room->floor_material = scene.materials.back().id;
    scene.luminaires.push_back(test::panel(scene, {2.0, 2.0, 2.0}, {4.0, 4.0}, 16000.0));
    const auto solution = solve(scene, 0.4);
    const PointValue floor = solution->face_means.at({scene.room->id, Room::floor_face});
    const double utilisation = floor.total().value * 16.0 / 16000.0;
    EXPECT_NEAR(utilisation, 0.604, 0.02 * 0.604);  // the cavity method takes every surface as uniform
}

TEST(ClosedRoom, the_paper_method_converges_to_the_patch_method_far_from_edges) {
    Scene scene = test::box_room({4.0, 3.0, 2.5}, 0.5);
    scene.luminaires.push_back(test::panel(scene, {2.0, 1.5, 2.5}, {1.0, 0.6}, 4000.0));
    scene.points.push_back(test::point(scene, {2.0, 1.5, 0.8}));
    const double good = solve(scene, 0.25)->points.front().value.interreflected.value;
    const double coarse = solve(scene, 0.8, Method::paper)->points.front().value.interreflected.value;
    const double fine = solve(scene, 0.2, Method::paper)->points.front().value.interreflected.value;
    EXPECT_LT(std::abs(fine - good), std::abs(coarse - good));
    EXPECT_NEAR(fine, good, 0.15 * good);  // the method's own error at edges: 15 % RMS at a thousand patches
}

}  // namespace
}  // namespace hanei
