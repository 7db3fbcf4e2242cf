#include "engine/mesh/mesh.h"
#include "tests/unit/mesh/sample_scenes.h"

#include <algorithm>
#include <gtest/gtest.h>

namespace hanei {
namespace {

std::size_t solids_in(const OccluderSet& occluders) {
    return static_cast<std::size_t>(std::count_if(occluders.bodies().begin(), occluders.bodies().end(),
                                                  [](const ConvexBody& body) { return body.faces.size() > 1; }));
}

TEST(Occluders, an_empty_convex_room_has_none) { EXPECT_TRUE(occluders_of(sample::box_room(4.0, 3.0, 2.5)).empty()); }

TEST(Occluders, an_l_shaped_room_has_its_two_re_entrant_walls) {
    const OccluderSet occluders = occluders_of(sample::l_room());
    ASSERT_EQ(occluders.bodies().size(), 2U);
    EXPECT_TRUE(occluders.blocks({3.5, 1.0, 1.0}, {1.0, 3.5, 1.0}));
    EXPECT_FALSE(occluders.blocks({3.5, 1.0, 1.0}, {0.5, 0.5, 1.0}));
}

TEST(Occluders, every_part_of_furniture_is_a_solid) {
    Scene scene = sample::box_room(4.0, 3.0, 2.5);
    sample::add_table(scene, {2.0, 1.5, 0.0});
    EXPECT_EQ(solids_in(occluders_of(scene)), 3U);
}

TEST(Occluders, a_part_that_is_not_convex_is_several_solids_that_hide_as_one) {
    Scene scene = sample::box_room(4.0, 3.0, 2.5);
    sample::add_l_shape(scene, {1, 1, 0}, 0.7);
    const OccluderSet occluders = occluders_of(scene);
    EXPECT_EQ(solids_in(occluders), 2U);
    EXPECT_EQ(occluders.bodies().size(), 2U);
    EXPECT_GE(occluders.containing({1.2, 1.2, 0.3}), 0);
    EXPECT_EQ(occluders.containing({1.8, 1.8, 0.3}), -1);                // in the corner of the L
    EXPECT_TRUE(occluders.blocks({1.25, 0.5, 0.3}, {1.25, 2.5, 0.3}));   // through both legs
    EXPECT_TRUE(occluders.blocks({0.5, 1.5, 0.3}, {1.4, 1.5, 0.4}));     // along the cut between them
    EXPECT_FALSE(occluders.blocks({1.6, 2.5, 0.3}, {1.51, 1.51, 0.3}));  // into the corner
    EXPECT_FALSE(occluders.blocks({1.6, 1.5, 0.3}, {2.5, 1.5, 0.3}));    // along the side in it
}

TEST(Occluders, a_box_of_free_surfaces_without_its_bottom_is_one_solid) {
    Scene scene = sample::box_room(4.0, 3.0, 2.5);
    sample::add_box_of_surfaces(scene, {1.0, 1.0, 0.0}, {1.5, 1.5, 0.7}, sample::without_bottom);
    const OccluderSet occluders = occluders_of(scene);
    EXPECT_EQ(occluders.bodies().size(), 1U);
    EXPECT_EQ(solids_in(occluders), 1U);
    EXPECT_EQ(occluders.containing({1.2, 1.2, 0.3}), 0);
}

TEST(Occluders, a_room_of_free_surfaces_hides_nothing) {
    Scene scene;
    sample::add_box_of_surfaces(scene, {0, 0, 0}, {4, 3, 2.5}, sample::closed_box);
    for (FreeSurface& wall : scene.surfaces) std::reverse(wall.region.outline.begin(), wall.region.outline.end());
    EXPECT_TRUE(occluders_of(scene).empty());
}

TEST(Occluders, a_leg_open_at_both_ends_is_solid_only_between_two_covers) {
    Scene scene = sample::box_room(4.0, 3.0, 2.5);
    sample::add_box_of_surfaces(scene, {1.0, 1.0, 0.0}, {1.1, 1.1, 0.7}, sample::sides_only);
    EXPECT_EQ(solids_in(occluders_of(scene)), 1U);  // the floor closes one end
    for (FreeSurface& side : scene.surfaces) {
        for (Vec3& corner : side.region.outline) corner.z += 0.1;
    }
    EXPECT_EQ(solids_in(occluders_of(scene)), 0U);  // a tube in the air can be looked through
    EXPECT_EQ(occluders_of(scene).bodies().size(), 4U);
}

TEST(Occluders, a_box_with_a_lamp_inside_is_no_solid) {
    Scene scene = sample::box_room(4.0, 3.0, 2.5);
    sample::add_box_of_surfaces(scene, {1.0, 1.0, 0.5}, {1.5, 1.5, 0.9}, sample::without_bottom);
    Luminaire lamp;
    lamp.id = scene.new_id();
    lamp.position = {1.25, 1.25, 0.7};
    scene.luminaires.push_back(lamp);
    EXPECT_EQ(solids_in(occluders_of(scene)), 0U);
    EXPECT_EQ(occluders_of(scene).bodies().size(), 5U);
}

TEST(Occluders, two_hinged_plates_are_left_as_they_are) {
    Scene scene;
    sample::add_surface(scene, {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}});
    sample::add_surface(scene, {{0, 0, 0}, {0, 1, 0}, {0, 1, 1}, {0, 0, 1}});
    EXPECT_TRUE(occluders_of(scene).empty());  // each has the other in front
}

TEST(Occluders, an_opaque_panel_hides_what_lies_behind_it) {
    Scene scene = sample::box_room(4.0, 3.0, 2.5);
    Luminaire panel;
    panel.id = scene.new_id();
    panel.position = {2.0, 1.5, 2.4};
    panel.opening = PolygonOpening{{{{-0.6, -0.3, 0}, {-0.6, 0.3, 0}, {0.6, 0.3, 0}, {0.6, -0.3, 0}}, {}}};
    panel.opaque = true;
    scene.luminaires.push_back(panel);
    const OccluderSet occluders = occluders_of(scene);
    ASSERT_EQ(occluders.bodies().size(), 1U);
    EXPECT_EQ(occluders.bodies()[0].owner, panel.id.value);
    EXPECT_TRUE(occluders.blocks({2.0, 1.5, 1.0}, {2.0, 1.5, 2.5}));
}

}  // namespace
}  // namespace hanei
