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
        EXPECT_EQ(spot.severity, Severity::note);
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

}  // namespace
}  // namespace hanei
