#include "ui/panels/wall_distances.h"

#include "engine/edit/edit.h"
#include "ui/panels/measure_points.h"
#include "ui/view/standpoint.h"

#include <gtest/gtest.h>

namespace hanei {
namespace {

/// Six by four metres, without the quarter beyond (3, 2).
Scene l_shaped() {
    Scene scene = empty_room();
    scene.room->plan = {{0.0, 0.0}, {6.0, 0.0}, {6.0, 2.0}, {3.0, 2.0}, {3.0, 4.0}, {0.0, 4.0}};
    scene.room->wall_materials.resize(6, scene.room->wall_materials.front());
    scene.luminaires.clear();
    scene.furniture.clear();
    return scene;
}

ObjectId box_at(Scene& scene, const Vec3& place) {
    Furniture box;
    box.id = scene.new_id();
    box.position = place;
    box.parts.emplace_back();
    scene.furniture.push_back(box);
    return box.id;
}

TEST(WallDistances, of_a_box_are_from_its_sides_to_the_walls_met_first) {
    Scene scene = l_shaped();
    const ObjectId chosen[] = {box_at(scene, {1.5, 3.0, 0.0})};
    const auto found = wall_distances(scene, chosen);
    ASSERT_EQ(found.size(), 4U);
    EXPECT_NEAR(found[0].metres(), 1.0, 1e-12) << "left";
    EXPECT_NEAR(found[1].metres(), 1.0, 1e-12) << "right: the short wall, not the one behind it";
    EXPECT_NEAR(found[2].metres(), 2.5, 1e-12);
    EXPECT_NEAR(found[3].metres(), 0.5, 1e-12);
}

TEST(WallDistances, of_a_luminaire_are_from_its_middle) {
    Scene scene = l_shaped();
    Luminaire luminaire;
    luminaire.id = scene.new_id();
    luminaire.position = {4.5, 0.5, 2.8};
    scene.luminaires.push_back(luminaire);
    const ObjectId chosen[] = {luminaire.id};
    const auto found = wall_distances(scene, chosen);
    ASSERT_EQ(found.size(), 4U);
    EXPECT_NEAR(found[0].metres(), 4.5, 1e-12);
    EXPECT_NEAR(found[1].metres(), 1.5, 1e-12);
    EXPECT_NEAR(found[2].metres(), 0.5, 1e-12);
    EXPECT_NEAR(found[3].metres(), 1.5, 1e-12);
}

TEST(WallDistances, are_not_to_walls_that_it_stands_at_nor_from_outside) {
    Scene scene = l_shaped();
    const ObjectId at_wall[] = {box_at(scene, {0.5, 1.0, 0.0})};
    EXPECT_EQ(wall_distances(scene, at_wall).size(), 3U);
    const ObjectId outside[] = {box_at(scene, {5.0, 3.5, 0.0})};
    EXPECT_TRUE(wall_distances(scene, outside).empty());
    EXPECT_TRUE(wall_distances(scene, {}).empty());
    scene.room.reset();
    EXPECT_TRUE(wall_distances(scene, at_wall).empty());
}

class Measuring : public testing::Test {
protected:
    Measuring() {
        box_at(scene, {1.5, 3.0, 0.0});
        pane.width = 900.0F;
        pane.height = 600.0F;
        pane.camera = camera_at(Standpoint::plan, bounds_of(scene), pane.aspect());
        marks = measure_marks(scene);
    }
    MeasurePoint at(const Vec3& place, float aside, double raster = 0.1, bool catches = true) {
        const ImVec2 seen = *pane.on_screen(place);
        return measure_point(scene, marks, pane, {seen.x + aside, seen.y}, raster, 10.0F, catches)
            .value_or(MeasurePoint{Vec3(-1.0), Catch::none});
    }
    Scene scene = l_shaped();
    Pane pane;
    MeasureMarks marks;
};

TEST_F(Measuring, catches_a_corner_nearby_rather_than_its_edges) {
    const MeasurePoint point = at({1.0, 2.5, 1.0}, 6.0F);
    EXPECT_EQ(point.caught, Catch::corner);
    EXPECT_LT(glm::distance(Vec2(point.place), Vec2(1.0, 2.5)), 1e-9);
    EXPECT_NEAR(point.place.z, 1.0, 1e-9) << "the upper one, which is seen";
}

TEST_F(Measuring, catches_an_edge_where_no_corner_is) {
    const MeasurePoint point = at({1.0, 2.8, 1.0}, 5.0F);
    EXPECT_EQ(point.caught, Catch::edge);
    EXPECT_NEAR(point.place.x, 1.0, 1e-9);
    EXPECT_NEAR(point.place.y, 2.8, 1e-6);  // pixels are floats
}

TEST_F(Measuring, catches_the_middle_of_furniture_on_its_top) {
    const MeasurePoint point = at({1.5, 3.0, 1.0}, 4.0F);
    EXPECT_EQ(point.caught, Catch::centre);
    EXPECT_LT(glm::distance(point.place, Vec3(1.5, 3.0, 1.0)), 1e-9);
}

TEST_F(Measuring, takes_the_raster_on_the_floor_and_any_place_when_it_is_free) {
    const Vec3 place{4.53, 0.94, 0.0};
    EXPECT_LT(glm::distance(at(place, 0.0F).place, Vec3(4.5, 0.9, 0.0)), 1e-9);
    EXPECT_EQ(at(place, 0.0F).caught, Catch::raster);
    EXPECT_LT(glm::distance(at(place, 0.0F, 0.0).place, place), 1e-6);
    EXPECT_EQ(at({1.0, 2.5, 1.0}, 6.0F, 0.1, false).caught, Catch::none) << "Ctrl";
}

TEST_F(Measuring, does_not_catch_what_the_section_leaves_out) {
    pane.camera.left_out.cut = Cut{{0.0, 0.0, 1.0}, 0.5};
    const MeasurePoint point = at({1.0, 2.5, 1.0}, 6.0F);
    EXPECT_LT(point.place.z, 0.5 + 1e-9);
}

TEST_F(Measuring, meets_nothing_beside_the_room) {
    EXPECT_FALSE(measure_point(scene, marks, pane, {2.0F, 2.0F}, 0.1, 10.0F, true));
}

}  // namespace
}  // namespace hanei
