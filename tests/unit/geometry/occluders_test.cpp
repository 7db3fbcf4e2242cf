#include "engine/geometry/occluders.h"

#include "engine/geometry/visible_part.h"
#include "tests/unit/geometry/shapes.h"

#include <algorithm>
#include <gtest/gtest.h>

namespace hanei {
namespace {

using testing::box_body;
using testing::Dice;
using testing::facing_down;
using testing::facing_up;
using testing::sheet;

TEST(Occluders, a_box_blocks_lines_through_it_and_no_line_along_it) {
    const OccluderSet set({box_body({0, 0, 0}, {1, 1, 1})});
    EXPECT_TRUE(set.blocks({-1, 0.5, 0.5}, {2, 0.5, 0.5}));
    EXPECT_FALSE(set.blocks({-1, 0.5, 1}, {2, 0.5, 1}));      // along the top
    EXPECT_FALSE(set.blocks({-1, 0, 1}, {2, 0, 1}));          // along an edge
    EXPECT_FALSE(set.blocks({-1, 0.5, 0.5}, {0, 0.5, 0.5}));  // ends on it
    EXPECT_FALSE(set.blocks({1, 0.5, 0.5}, {2, 0.5, 0.5}));   // starts on it
    EXPECT_FALSE(set.blocks({-1, 0.5, 0.5}, {-0.1, 0.5, 0.5}));
    EXPECT_TRUE(set.blocks({0, 0.5, 0.5}, {2, 0.5, 0.5}));    // from its skin through its body
    EXPECT_TRUE(set.blocks({0.5, 0.5, 0.5}, {2, 0.5, 0.5}));  // from within
}

TEST(Occluders, a_sheet_blocks_lines_through_it_from_both_sides) {
    const OccluderSet set({sheet(facing_up(0, 0, 1, 1, 1))});
    EXPECT_TRUE(set.blocks({0.5, 0.5, 0}, {0.5, 0.5, 2}));
    EXPECT_TRUE(set.blocks({0.5, 0.5, 2}, {0.5, 0.5, 0}));
    EXPECT_FALSE(set.blocks({0.5, 0.5, 0}, {0.5, 0.5, 1}));  // ends on it
    EXPECT_FALSE(set.blocks({-1, 0.5, 1}, {2, 0.5, 1}));     // within its plane
    EXPECT_FALSE(set.blocks({1, 0.5, 0}, {1, 0.5, 2}));      // touches its edge
    EXPECT_FALSE(set.blocks({1.5, 0.5, 0}, {1.5, 0.5, 2}));
}

TEST(Occluders, a_body_wound_the_wrong_way_round_blocks_all_the_same) {
    ConvexBody box = box_body({0, 0, 0}, {1, 1, 1});
    for (auto& face : box.faces) std::ranges::reverse(face);
    const OccluderSet set({box});
    EXPECT_TRUE(set.blocks({-1, 0.5, 0.5}, {2, 0.5, 0.5}));
    EXPECT_FALSE(set.blocks({-1, 1.5, 0.5}, {2, 1.5, 0.5}));
}

TEST(Occluders, a_solid_without_thickness_is_a_sheet) {
    const OccluderSet set({box_body({0, 0, 1}, {1, 1, 1})});
    EXPECT_TRUE(set.shape(0).flat);
    EXPECT_TRUE(set.blocks({0.5, 0.5, 0}, {0.5, 0.5, 2}));
    EXPECT_EQ(set.containing({0.5, 0.5, 1}), -1);
}

TEST(Occluders, a_tenth_of_a_millimetre_of_wall_is_tight) {
    const OccluderSet set({box_body({0, -5, 0}, {1e-4, 5, 3})});
    Dice dice(1);
    for (int k = 0; k < 10'000; ++k) {
        const Vec3 left{dice.uniform(-4, -1e-6), dice.uniform(-4, 4), dice.uniform(0.1, 2.9)};
        const Vec3 right{dice.uniform(2e-4, 4), dice.uniform(-4, 4), dice.uniform(0.1, 2.9)};
        ASSERT_TRUE(set.blocks(left, right));
    }
}

TEST(Occluders, places_inside_are_found_and_places_on_the_skin_are_not) {
    const OccluderSet set({box_body({0, 0, 0}, {1, 1, 1}), box_body({0.5, 0, 0}, {2, 1, 1})});
    EXPECT_EQ(set.containing({0.7, 0.5, 0.5}), 0);
    EXPECT_EQ(set.containing({1.5, 0.5, 0.5}), 1);
    EXPECT_EQ(set.containing({1.5, 0.5, 1}), -1);
    EXPECT_EQ(set.containing({3, 0.5, 0.5}), -1);
}

TEST(Occluders, an_empty_set_blocks_nothing) {
    const OccluderSet set;
    std::vector<BodyIndex> found;
    set.between({0, 0, 0}, std::vector<Vec3>{{1, 1, 1}}, found);
    EXPECT_TRUE(found.empty() && set.empty());
    EXPECT_FALSE(set.blocks({0, 0, 0}, {1, 1, 1}));
    EXPECT_EQ(set.containing({0, 0, 0}), -1);
}

TEST(Occluders, no_body_on_a_sight_line_is_missed_among_thousands) {
    Dice dice(6);
    std::vector<ConvexBody> bodies;
    for (int k = 0; k < 3000; ++k) {
        const Vec3 low = dice.place(10);
        bodies.push_back(box_body(low, low + Vec3{dice.uniform(0.05, 0.6), dice.uniform(0.05, 0.6), 0.4}));
    }
    const OccluderSet set(std::move(bodies));
    std::vector<BodyIndex> everything(set.bodies().size());
    for (std::size_t k = 0; k < everything.size(); ++k) everything[k] = static_cast<BodyIndex>(k);
    int blocked = 0;
    for (int k = 0; k < 1000; ++k) {
        const Vec3 from = dice.place(10), to = dice.place(10);
        const bool truth = set.blocks(from, to, everything);
        EXPECT_EQ(set.blocks(from, to), truth);
        blocked += truth;
    }
    EXPECT_GT(blocked, 300);
    EXPECT_LT(blocked, 990);
}

TEST(Occluders, what_lies_between_a_patch_and_an_opening_is_never_missed) {
    Dice dice(8);
    int clear = 0;
    for (int k = 0; k < 2000; ++k) {
        const Vec3 low = dice.place(1.5);
        const OccluderSet set({box_body(low, low + Vec3{dice.uniform(0.1, 0.8), dice.uniform(0.1, 0.8), 0.3})});
        const Mat3 turn = dice.rotation();
        Polygon patch = facing_up(-0.3, -0.2, 0.3, 0.2, 0), opening = facing_up(-0.6, -0.3, 0.6, 0.3, 0);
        for (Vec3& corner : patch) corner.z -= 1.5;
        for (Vec3& corner : opening) corner = turn * corner + Vec3{0, 0, 1.5};
        std::vector<BodyIndex> found;
        set.between(patch, opening, found);
        if (!found.empty()) continue;
        ++clear;
        for (int j = 0; j < 40; ++j) {
            const double a = dice.uniform(0, 1), b = dice.uniform(0, 1), c = dice.uniform(0, 1), d = dice.uniform(0, 1);
            const Vec3 from = patch[0] + a * (patch[1] - patch[0]) + b * (patch[3] - patch[0]);
            const Vec3 to = opening[0] + c * (opening[1] - opening[0]) + d * (opening[3] - opening[0]);
            ASSERT_FALSE(set.blocks(from, to));
        }
    }
    EXPECT_GT(clear, 1000);  // and bodies beside the shaft are told apart
}

TEST(Occluders, no_light_passes_between_bodies_that_touch) {
    const ConvexBody left = box_body({-1, -1, 0}, {0, 1, 1}), right = box_body({0, -1, 0}, {1, 1, 1});
    const OccluderSet set({left, right});
    EXPECT_TRUE(set.blocks({0, -2, 0.5}, {0, 2, 0.5}));                         // along their contact
    EXPECT_TRUE(set.blocks({0, 0, -1}, {0, 0.3, 2}));                           // aslant in it
    EXPECT_TRUE(set.blocks({0, 0, 0}, {0, 0.3, 2}));                            // from the floor under it
    EXPECT_FALSE(set.blocks({0, -2, 1}, {0, 2, 1}));                            // over the contact, along both tops
    EXPECT_FALSE(set.blocks({0, 0, 1}, {0, 0.3, 2}));                           // starts on top of it
    EXPECT_FALSE(set.blocks({0, -2, 0.5}, {0, -1, 0.5}));                       // ends where it begins
    EXPECT_FALSE(OccluderSet({left, left}).blocks({0, -2, 0.5}, {0, 2, 0.5}));  // one body twice has a free side
}

TEST(Occluders, light_goes_from_leg_to_leg_along_the_underside_of_a_table) {
    const OccluderSet table({box_body({0, 0, 0.7}, {2, 1, 0.72}), box_body({0, 0, 0}, {0.05, 1, 0.7}),
                             box_body({1.95, 0, 0}, {2, 1, 0.7})});
    EXPECT_FALSE(table.blocks({0.05, 0.1, 0.7}, {1.95, 0.9, 0.7}));
    EXPECT_TRUE(table.blocks({0.025, 0.1, 0.7}, {1.95, 0.9, 0.7}));  // begins between leg and top
}

TEST(Occluders, a_row_on_a_face_is_not_hidden_by_its_own_body_in_the_plane_of_the_floor) {
    const OccluderSet set({box_body({2, 0, 0}, {3, 2, 1}), box_body({1, 0.5, 0}, {1.2, 1, 1})});
    const std::vector<BodyIndex> both = {0, 1};
    const auto visible = visible_intervals({2, 0, 0}, {2, 2, 0}, {0, 1, 0}, set, both);
    ASSERT_EQ(visible.size(), 1U);
    EXPECT_EQ(visible[0].first, 0.0);
    EXPECT_EQ(visible[0].second, 1.0);
}

TEST(Occluders, no_light_passes_where_four_boxes_meet_or_through_the_seam_of_two_sheets) {
    const OccluderSet four({box_body({-1, -1, 0}, {0, 1, 1}), box_body({0, -1, 0}, {1, 1, 1}),
                            box_body({-1, -1, 1}, {0, 1, 2}), box_body({0, -1, 1}, {1, 1, 2})});
    EXPECT_TRUE(four.blocks({0, -2, 1}, {0, 2, 1}));
    const OccluderSet step(
        {box_body({-1, -1, 0}, {0, 1, 1}), box_body({0, -1, 0}, {1, 1, 1}), box_body({-1, -1, 1}, {0, 1, 2})});
    EXPECT_FALSE(step.blocks({0, -2, 1}, {0, 2, 1}));  // the concave edge of a step is free on one side
    const OccluderSet seam({sheet(facing_up(-1, -1, 0, 1, 1)), sheet(facing_up(0, -1, 1, 1, 1))});
    EXPECT_TRUE(seam.blocks({0, 0, 0}, {0, 0.5, 2}));
    EXPECT_TRUE(seam.blocks({-0.5, 0, 0}, {0.5, 0.5, 2}));
    EXPECT_FALSE(seam.blocks({0, -1, 0}, {0, -1, 2}));  // at its end
}

TEST(Occluders, no_light_passes_along_a_contact_that_lies_aslant) {
    Dice dice(41);
    for (int k = 0; k < 300; ++k) {
        const Mat3 turn = dice.rotation();
        const Vec3 at = dice.place(3);
        std::vector<ConvexBody> bodies{box_body({-1, -1, -1}, {0, 1, 1}), box_body({0, -0.7, -0.6}, {1, 0.8, 0.9})};
        for (ConvexBody& body : bodies) {
            for (Vec3& vertex : body.vertices) vertex = turn * vertex + at;
        }
        const OccluderSet set(std::move(bodies));
        const auto placed = [&](double y, double z) { return turn * Vec3{0, y, z} + at; };
        const double y = dice.uniform(-0.6, 0.7), z = dice.uniform(-0.5, 0.8);
        EXPECT_TRUE(set.blocks(placed(-3, dice.uniform(-2, 2)), placed(y, z)));  // ends between them
        EXPECT_FALSE(set.blocks(placed(-3, z), placed(-0.9, z)));                // reaches one of them only
    }
}

TEST(Occluders, a_desk_does_not_stand_between_its_own_top_and_the_ceiling) {
    const OccluderSet set({box_body({0, 0, 0}, {1, 1, 0.7})});
    std::vector<BodyIndex> found;
    set.between(facing_up(0, 0, 0.5, 0.5, 0.7), facing_up(-1, -1, 2, 2, 2.8), found);
    EXPECT_TRUE(found.empty());
    set.between(facing_up(-0.5, 0, -0.1, 0.5, 0), facing_up(-1, -1, 2, 2, 2.8), found);
    EXPECT_EQ(found.size(), 1U);
}

TEST(Occluders, a_body_that_hides_all_of_an_opening_is_named_alone) {
    const OccluderSet set({box_body({-0.1, -0.1, 2}, {0.1, 0.1, 2.1}), box_body({-5, -5, 1}, {5, 5, 1.1}),
                           sheet(facing_up(-4, -4, 4, 4, 0.5))});
    const Polygon opening = facing_down(-0.6, -0.3, 0.6, 0.3, 2.8);
    std::vector<BodyIndex> found;
    set.between({0, 0, 0.7}, opening, found);
    EXPECT_EQ(found, std::vector<BodyIndex>{1});
    found.clear();
    set.between({0, 0, 1.5}, opening, found);
    EXPECT_EQ(found, std::vector<BodyIndex>{0});
    for (const double z : {0.0, 0.2}) {  // under both the box and the sheet: either hides it
        found.clear();
        set.between({0, 0, z}, opening, found);
        ASSERT_EQ(found.size(), 1U);
        EXPECT_GE(found[0], 1U);
    }
}

TEST(Occluders, a_source_s_own_body_is_left_out_and_hides_nothing_of_it) {
    ConvexBody own = box_body({-1, -1, 1}, {1, 1, 1.5});
    own.owner = 7;
    const OccluderSet set({own, box_body({-0.1, -0.1, 2}, {0.1, 0.1, 2.1})});
    const Polygon opening = facing_down(-0.6, -0.3, 0.6, 0.3, 2.8);
    const std::vector<BodyIndex> all{0, 1};
    for (int k = 0; k < 2; ++k) {  // also when the last look ended in that body
        std::vector<BodyIndex> found;
        set.between({0, 0, 0}, opening, found);
        EXPECT_EQ(found, std::vector<BodyIndex>{0});
        found.clear();
        set.between({0, 0, 0}, opening, found, 7);
        EXPECT_EQ(found, std::vector<BodyIndex>{1});
        found.clear();
        set.between({0, 0, 0}, opening, all, found, 7);
        EXPECT_EQ(found, std::vector<BodyIndex>{1});
    }
}

TEST(Occluders, bodies_from_a_millimetre_to_a_kilometre_are_all_found) {
    for (const double scale : {1e-3, 1.0, 1e3}) {
        Dice dice(21);
        std::vector<ConvexBody> bodies;
        const Vec3 far_away = 1e4 * scale * dice.direction();
        for (int k = 0; k < 200; ++k) {
            const Vec3 low = scale * dice.place(5) + far_away;
            bodies.push_back(box_body(low, low + scale * Vec3{dice.uniform(0.001, 0.9), dice.uniform(0.05, 0.6), 0.4}));
        }
        for (int k = 0; k < 20; ++k) bodies.push_back(bodies[0]);  // all at one place
        const OccluderSet set(std::move(bodies));
        std::vector<BodyIndex> everything(set.bodies().size());
        for (std::size_t k = 0; k < everything.size(); ++k) everything[k] = static_cast<BodyIndex>(k);
        for (int k = 0; k < 500; ++k) {
            const Vec3 from = scale * dice.place(6) + far_away, to = scale * dice.place(6) + far_away;
            EXPECT_EQ(set.blocks(from, to), set.blocks(from, to, everything)) << scale;
        }
    }
}

}  // namespace
}  // namespace hanei
