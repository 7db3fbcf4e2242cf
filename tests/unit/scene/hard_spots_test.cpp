/// What is hard about a scene is told, once, and nothing of a plain one.
#include "engine/scene/hard_spots.h"

#include "tests/box_room.h"

#include <algorithm>
#include <gtest/gtest.h>

namespace hanei {
namespace {

Scene plain_room() {
    Scene scene = test::box_room({4.0, 3.0, 2.6}, 0.5);
    scene.luminaires.push_back(test::panel(scene, {2.0, 1.5, 2.5}, {0.8, 0.4}, 3000.0));
    scene.furniture = {test::box(scene, {1.0, 1.0, 0.0}, {0.8, 0.6, 0.7})};
    return scene;
}

std::ptrdiff_t notes_with(const Scene& scene, const std::string& words) {
    const Diagnostics spots = hard_spots(scene);
    return std::count_if(spots.begin(), spots.end(), [&](const Diagnostic& spot) {
        EXPECT_EQ(spot.severity, Severity::note) << spot.message;
        return spot.message.find(words) != std::string::npos;
    });
}

TEST(HardSpots, a_plain_room_has_none) {
    for (const Diagnostic& spot : hard_spots(plain_room())) ADD_FAILURE() << spot.message;
}

TEST(HardSpots, bodies_that_touch_or_nearly_do_are_told_of_with_their_gap) {
    Scene scene = plain_room();
    scene.furniture.push_back(test::box(scene, {1.8, 1.0, 0.0}, {0.8, 0.6, 0.7}));
    EXPECT_EQ(notes_with(scene, "stands against"), 1);
    scene.furniture.back().position.x += 0.0005;
    EXPECT_EQ(notes_with(scene, "stands 0.5 mm from"), 1);
    scene.furniture.back().position.x += 0.01;
    EXPECT_EQ(hard_spots(scene).size(), 0U);
}

TEST(HardSpots, sheets_in_one_plane_are_told_of_only_where_they_overlap) {
    Scene scene = plain_room();
    const auto hang = [&](double x) {
        const Polygon outline{{x, 1.0, 1.5}, {x + 1.0, 1.0, 1.5}, {x + 1.0, 2.0, 1.5}, {x, 2.0, 1.5}};
        scene.surfaces.push_back({scene.new_id(), "sheet", {outline, {}}, scene.materials.front().id, {0.0}, {}});
    };
    hang(0.5);
    hang(1.5);
    EXPECT_EQ(notes_with(scene, "in one plane"), 0);
    hang(1.0);
    EXPECT_EQ(notes_with(scene, "in one plane"), 1);
    hang(0.5);
    EXPECT_EQ(notes_with(scene, "both would be lit"), 2);
}

TEST(HardSpots, an_opening_that_reaches_through_the_ceiling_is_told_of_with_its_height) {
    Scene scene = plain_room();
    Photometry table;
    table.id = scene.new_id();
    table.horizontal_deg = {0.0};
    table.vertical_deg = {0.0, 90.0};
    table.candela = {100.0, 0.0};
    table.opening = {OpeningShape::box, 0.6, 0.6, 0.1};
    scene.photometries = {table};
    Luminaire& luminaire = scene.luminaires.front();
    luminaire.opening = MeasuredOpening{};
    luminaire.distribution = Measured{table.id};
    luminaire.output = AsMeasured{};
    EXPECT_EQ(notes_with(scene, "through the ceiling"), 0);
    luminaire.position.z = 2.6;
    EXPECT_EQ(notes_with(scene, "reaches 0.05 m through the ceiling"), 1);
}

CalculationPoint at(Scene& scene, const Vec3& place, const Vec3& normal = {0.0, 0.0, 1.0}) {
    return test::point(scene, place, normal);
}

TEST(HardSpots, a_point_is_told_of_the_source_in_whose_plane_or_before_which_it_lies) {
    Scene scene = plain_room();
    scene.points = {at(scene, {3.0, 1.5, 2.5})};
    EXPECT_EQ(notes_with(scene, "lies in the plane of"), 1);
    scene.points = {at(scene, {2.0, 1.5, 2.499})};
    EXPECT_EQ(notes_with(scene, "it lies 1 mm from"), 1);
    scene.points = {at(scene, {2.0, 1.5, 2.4})};
    EXPECT_EQ(hard_spots(scene).size(), 0U);
    scene.luminaires.front().opening = LineOpening{{-0.5, 0.0, 0.0}, {0.5, 0.0, 0.0}};
    scene.points = {at(scene, {3.0, 1.5, 2.5})};
    EXPECT_EQ(notes_with(scene, "in line with"), 1);
    scene.luminaires.front().opening = PointOpening{};
    scene.points = {at(scene, {2.0, 1.5, 2.5})};
    EXPECT_EQ(notes_with(scene, "a lamp without extent"), 1);
}

TEST(HardSpots, a_luminous_sheet_is_told_of_to_points_beside_it_and_not_to_those_on_it) {
    Scene scene = plain_room();
    const Polygon outline{{3.0, 1.0, 0.0}, {3.0, 1.0, 1.0}, {3.0, 2.0, 1.0}, {3.0, 2.0, 0.0}};  // faces west
    scene.surfaces = {{scene.new_id(), "wall", {outline, {}}, scene.materials.front().id, {100.0}, {}}};
    scene.points = {at(scene, {3.0, 1.5, 0.5}, {-1.0, 0.0, 0.0})};
    EXPECT_EQ(hard_spots(scene).size(), 0U);
    scene.points = {at(scene, {3.0, 1.5, 1.5})};
    EXPECT_EQ(notes_with(scene, "lies in the plane of"), 1);
    scene.points = {at(scene, {3.0, 1.5, 0.5}, {1.0, 0.0, 0.0})};
    EXPECT_EQ(notes_with(scene, "on the back of the sheet"), 1);
    scene.points = {at(scene, {2.0, 1.5, 0.7})};
    EXPECT_EQ(notes_with(scene, "lies behind it and a part before it"), 1);
}

TEST(HardSpots, a_point_in_a_corner_or_by_the_edge_of_a_hard_shadow_is_told) {
    Scene scene = plain_room();
    scene.points = {at(scene, {0.0, 0.0, 0.0})};
    EXPECT_EQ(notes_with(scene, "in 3 faces of the room"), 1);
    scene.points = {at(scene, {2.0, 0.0, 0.0})};
    EXPECT_EQ(notes_with(scene, "in 2 faces of the room"), 1);
    scene.luminaires = {test::point_source(scene, {1.0, 1.0, 1.4}, 1000.0)};  // twice as high as the box
    scene.points = {at(scene, {1.8005, 1.0, 0.0})};
    EXPECT_EQ(notes_with(scene, "has no penumbra"), 1);
    scene.points = {at(scene, {1.9, 1.0, 0.0})};
    EXPECT_EQ(notes_with(scene, "has no penumbra"), 0);
}

TEST(HardSpots, luminaires_are_told_of_among_each_other_and_by_their_shape) {
    Scene scene = plain_room();
    scene.luminaires.push_back(test::panel(scene, {2.8, 1.5, 2.5}, {0.8, 0.4}, 3000.0));
    EXPECT_EQ(notes_with(scene, "shares an edge with"), 1);
    scene.luminaires.back().position.x += 0.01;
    EXPECT_EQ(hard_spots(scene).size(), 0U);
    scene.luminaires.back().opaque = true;
    EXPECT_EQ(notes_with(scene, "it is opaque"), 1);
    scene.luminaires.back() = test::panel(scene, {3.0, 1.5, 2.5}, {2e-4, 2e-4}, 10.0);
    EXPECT_EQ(notes_with(scene, "ten thousandth of the scene"), 1);
    scene.luminaires.back() = test::point_source(scene, {3.0, 1.5, 2.5}, 10.0);
    scene.luminaires.back().distribution = CosinePower{2000.0};
    EXPECT_EQ(notes_with(scene, "half of its light falls within"), 1);
    scene.luminaires.back() = test::point_source(scene, {3.0, 1.5, 0.7}, 10.0);
    EXPECT_EQ(notes_with(scene, "which it sees end on"), 1);
}

TEST(HardSpots, a_body_right_before_an_opening_is_told_with_its_distance) {
    Scene scene = plain_room();
    scene.furniture.push_back(test::box(scene, {2.0, 1.5, 2.4}, {1.0, 1.0, 0.0999}));
    EXPECT_EQ(notes_with(scene, "stands 0.1 mm before it"), 1);
    scene.furniture.back().position.x = 0.6;  // beside it
    EXPECT_EQ(notes_with(scene, "before it"), 0);
}

TEST(HardSpots, light_that_never_ends_never_starts_or_never_was_is_told) {
    Scene scene = plain_room();
    scene.materials.front().reflectance = 1.0;
    EXPECT_EQ(notes_with(scene, "it absorbs nothing"), 1);
    scene.materials.front().reflectance = 0.0;
    EXPECT_EQ(notes_with(scene, "nothing reflects"), 1);
    scene = plain_room();
    scene.luminaires.front().dimming = 0.0;
    EXPECT_EQ(notes_with(scene, "nothing shines"), 1);
}

TEST(HardSpots, a_plan_that_is_not_convex_is_told_with_its_corners) {
    Scene scene = plain_room();
    scene.room->plan = {{0.0, 0.0}, {4.0, 0.0}, {4.0, 3.0}, {2.0, 3.0}, {2.0, 2.0}, {0.0, 2.0}};
    EXPECT_EQ(notes_with(scene, "1 corner that juts in"), 1);
    EXPECT_EQ(hard_spots(scene).front().place.field, "room.plan");
}

TEST(HardSpots, sheets_that_meet_at_a_sharp_angle_are_told_of_and_not_taken_for_one) {
    Scene scene = plain_room();
    scene.surfaces = {
        {scene.new_id(), "a", {{{1, 1, 0}, {3, 1, 0}, {3, 1, 2}, {1, 1, 2}}, {}}, scene.materials.front().id, {}, {}},
        {scene.new_id(),
         "b",
         {{{1, 1, 2}, {3, 0.99, 2}, {3, 0.99, 0}, {1, 1, 0}}, {}},
         scene.materials.front().id,
         {},
         {}}};
    EXPECT_EQ(notes_with(scene, "less than 5 degrees"), 1);
    EXPECT_EQ(notes_with(scene, "both would be lit"), 0);
}

TEST(HardSpots, the_verdict_counts_what_was_found) {
    EXPECT_EQ(verdict_of({}), "nothing to complain about");
    const Diagnostic error{Severity::error, {}, ""}, warning{Severity::warning, {}, ""}, note{Severity::note, {}, ""};
    EXPECT_EQ(verdict_of({note, note, note}), "no errors; 3 notes");
    EXPECT_EQ(verdict_of({warning}), "no errors, 1 warning");
    EXPECT_EQ(verdict_of({error, warning, warning, note}), "1 error, 2 warnings; 1 note");
}

}  // namespace
}  // namespace hanei
