#include "engine/geometry/visible_part.h"

#include "engine/geometry/configuration_factor.h"
#include "engine/geometry/polygon.h"
#include "tests/unit/geometry/shapes.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <numeric>

namespace hanei {
namespace {

using testing::box_body;
using testing::Dice;
using testing::facing_down;
using testing::facing_up;
using testing::sheet;

std::vector<BodyIndex> all_of(const OccluderSet& set) {
    std::vector<BodyIndex> all(set.bodies().size());
    std::iota(all.begin(), all.end(), 0U);
    return all;
}

double visible_share(const Polygon& polygon, const Vec3& eye, const OccluderSet& set) {
    double area = 0;
    for (const Polygon& piece : visible_part(polygon, eye, set, all_of(set))) area += glm::length(vector_area(piece));
    return area / glm::length(vector_area(polygon));
}

// Tolerance of areas and factors below: cuts are exact to rounding, 1e-14 leaves a factor 50.
constexpr double exact = 1e-14;

TEST(VisiblePart, a_box_hides_its_central_projection) {
    const OccluderSet set({box_body({0, -5, 1}, {5, 5, 1.5})});
    // From the origin the box's edge at x = 0 cuts the opening in the middle.
    EXPECT_NEAR(visible_share(facing_down(-1, -1, 1, 1, 3), {0, 0, 0}, set), 0.5, exact);
    // From x = -1 the upper edge decides: (0, 1.5) projects to x = 1 at height 3; the lower edge to 2.
    EXPECT_NEAR(visible_share(facing_down(-1, -1, 1, 1, 3), {-1, 0, 0}, set), 1.0, exact);
    EXPECT_NEAR(visible_share(facing_down(-1, -1, 3, 1, 3), {-1, 0, 0}, set), 0.5, exact);
}

TEST(VisiblePart, a_sheet_hides_from_both_sides_and_nothing_edge_on) {
    const OccluderSet set({sheet(facing_up(0, -5, 5, 5, 1))});
    EXPECT_NEAR(visible_share(facing_down(-1, -1, 1, 1, 3), {0, 0, 0}, set), 0.5, exact);
    EXPECT_NEAR(visible_share(facing_up(-1, -1, 1, 1, -1), {0, 0, 3}, set), 0.5, exact);
    const Polygon wall = {{2, -1, 0}, {2, 1, 0}, {2, 1, 2}, {2, -1, 2}};
    EXPECT_NEAR(visible_share(wall, {-1, 0, 1}, set), 1.0, exact);
}

TEST(VisiblePart, a_body_hides_only_what_lies_beyond_it) {
    const OccluderSet set({box_body({-1, -1, 1}, {1, 1, 2})});
    EXPECT_NEAR(visible_share(facing_down(-0.5, -0.5, 0.5, 0.5, 0.9), {0, 0, 0}, set), 1.0, exact);
    EXPECT_NEAR(visible_share(facing_down(-0.5, -0.5, 0.5, 0.5, 2.1), {0, 0, 0}, set), 0.0, exact);
    // An upright opening that pierces the box's lower face at height 1: what is above is inside it.
    const Polygon piercing = {{-0.2, 0.1, 0.5}, {0.2, 0.1, 0.5}, {0.2, 0.1, 1.5}, {-0.2, 0.1, 1.5}};
    EXPECT_NEAR(visible_share(piercing, {0, 0, 0}, set), 0.5, exact);
}

TEST(VisiblePart, an_opening_flush_with_a_box_is_visible_from_its_front) {
    const OccluderSet set({box_body({-1, -1, 2}, {1, 1, 3})});
    EXPECT_NEAR(visible_share(facing_down(-0.5, -0.5, 0.5, 0.5, 2), {0.3, 0.2, 0}, set), 1.0, exact);
    EXPECT_NEAR(visible_share(facing_down(-0.5, -0.5, 1.5, 0.5, 2), {3, 0.2, 1.9}, set), 1.0, exact);
    EXPECT_NEAR(visible_share(facing_up(-0.5, -0.5, 0.5, 0.5, 3), {0.3, 0.2, 0}, set), 0.0, exact);
}

TEST(VisiblePart, a_sheet_with_the_opening_s_own_outline_does_not_hide_it) {
    const Polygon opening = facing_down(-0.6, -0.3, 0.6, 0.3, 2.8);
    const OccluderSet set({sheet(opening)});
    EXPECT_NEAR(visible_share(opening, {2, 1, 0.8}, set), 1.0, exact);
}

TEST(VisiblePart, a_point_on_a_desk_top_is_lit_from_above_and_dark_from_below) {
    const OccluderSet set({box_body({-1, -1, 0.7}, {1, 1, 0.75})});
    EXPECT_NEAR(visible_share(facing_down(-1, -1, 1, 1, 3), {0.2, 0, 0.75}, set), 1.0, exact);
    EXPECT_NEAR(visible_share(facing_up(-1, -1, 1, 1, 0), {0.2, 0, 0.75}, set), 0.0, exact);
    // On the desk's edge half of the view below it opens.
    EXPECT_NEAR(visible_share(facing_up(0, -1, 2, 1, 0), {1, 0, 0.75}, set), 0.5, exact);
}

TEST(VisiblePart, a_point_on_the_plane_of_a_top_sees_along_it) {
    const OccluderSet set({box_body({1, -1, 0}, {2, 1, 1})});
    const Polygon wall = {{3, -0.5, 0}, {3, -0.5, 2}, {3, 0.5, 2}, {3, 0.5, 0}};
    EXPECT_NEAR(visible_share(wall, {0, 0, 1}, set), 0.5, exact);
}

TEST(VisiblePart, a_body_around_the_eye_hides_everything) {
    const OccluderSet set({box_body({-1, -1, -1}, {1, 1, 1})});
    EXPECT_EQ(visible_share(facing_down(-9, -9, 9, 9, 3), {0.5, 0, 0}, set), 0.0);
}

TEST(VisiblePart, bodies_that_coincide_hide_as_one) {
    const ConvexBody box = box_body({0, -5, 1}, {5, 5, 1.5});
    const OccluderSet once({box}), thrice({box, box, box});
    const Polygon opening = facing_down(-1, -1, 1.7, 1, 3);
    EXPECT_DOUBLE_EQ(visible_share(opening, {-0.3, 0.1, 0}, thrice), visible_share(opening, {-0.3, 0.1, 0}, once));
}

TEST(VisiblePart, touching_boxes_leave_no_line_of_light) {
    const OccluderSet apart({box_body({-5, -5, 1}, {0, 5, 2}), box_body({0, -5, 1}, {5, 5, 2})});
    for (const double x : {-0.3, 0.0, 0.1, 1e-9}) {
        EXPECT_NEAR(visible_share(facing_down(-1, -1, 1, 1, 3), {x, 0, 0}, apart), 0.0, exact) << x;
    }
}

TEST(VisiblePart, the_foot_of_a_partition_does_not_see_through_it) {
    const OccluderSet set({sheet({{0, -2, 0}, {0, 2, 0}, {0, 2, 2}, {0, -2, 2}})});
    const Polygon behind = facing_down(-3, -1, -1, 1, 1.5);
    const Polygon in_front = facing_down(1, -1, 3, 1, 1.5);
    const Receiver foot{{0, 0, 0}, {0, 0, 1}, {1, 0, 0}};
    EXPECT_EQ(visible_configuration_factor(behind, foot, set, all_of(set)), 0.0);
    EXPECT_DOUBLE_EQ(visible_configuration_factor(in_front, foot, set, all_of(set)),
                     configuration_factor(in_front, foot));
}

struct Furnished {
    OccluderSet set;
    Polygon opening;
};

Furnished random_room(Dice& dice, int bodies) {
    std::vector<ConvexBody> all;
    for (int k = 0; k < bodies; ++k) {
        const Vec3 half{dice.uniform(0.02, 0.5), dice.uniform(0.02, 0.5), dice.uniform(0.02, 0.5)};
        ConvexBody body = box_body(-half, half);
        if (k % 4 == 3) body = sheet(facing_up(-half.x, -half.y, half.x, half.y, 0));
        const Mat3 turn = k % 2 == 0 ? Mat3{1.0} : dice.rotation();
        const Vec3 at{dice.uniform(-1, 1), dice.uniform(-1, 1), dice.uniform(-0.2, 2.2)};
        for (Vec3& vertex : body.vertices) vertex = turn * vertex + at;
        all.push_back(body);
    }
    const Mat3 turn = dice.rotation();
    Polygon opening = facing_down(-0.8, -0.4, 0.8, 0.4, 0);
    for (Vec3& corner : opening) corner = turn * corner + Vec3{0, 0, 1.8};
    return {OccluderSet(std::move(all)), opening};
}

bool in_piece(const Polygon& piece, const Vec3& normal, const Vec3& place, double margin) {
    for (std::size_t k = 0; k < piece.size(); ++k) {
        const Vec3 run = piece[(k + 1) % piece.size()] - piece[k];
        if (glm::dot(glm::cross(normal, run), place - piece[k]) < -margin * glm::length(run)) return false;
    }
    return true;
}

TEST(VisiblePart, every_sampled_sight_line_agrees) {
    Dice dice(3);
    int disagreements = 0, partly = 0;
    for (int k = 0; k < 600; ++k) {
        const Furnished room = random_room(dice, 8);
        const Vec3 eye = dice.place(1.2);
        const Vec3 normal = unit_normal(room.opening);
        const std::vector<Polygon> pieces = visible_part(room.opening, eye, room.set, all_of(room.set));
        int seen = 0;
        for (int j = 0; j < 100; ++j) {
            const double u = dice.uniform(0, 1), v = dice.uniform(0, 1);
            const Vec3 place =
                room.opening[0] + u * (room.opening[1] - room.opening[0]) + v * (room.opening[3] - room.opening[0]);
            const bool open = !room.set.blocks(eye, place);
            const auto holds = [&](double margin) {
                return std::ranges::any_of(pieces,
                                           [&](const Polygon& p) { return in_piece(p, normal, place, margin); });
            };
            // Within a tenth of a micrometre of a border either answer is right.
            if (open ? !holds(1e-7) : holds(-1e-7)) ++disagreements;
            seen += open;
        }
        partly += seen > 0 && seen < 100;
    }
    EXPECT_EQ(disagreements, 0);
    EXPECT_GT(partly, 150);  // the rooms do test penumbra
}

TEST(VisiblePart, candidates_between_give_the_same_as_all_bodies) {
    Dice dice(5);
    for (int k = 0; k < 400; ++k) {
        const Furnished room = random_room(dice, 40);
        const Receiver receiver{dice.place(1.5), dice.direction(), {}};
        std::vector<BodyIndex> some;
        room.set.between(receiver.position, room.opening, some);
        EXPECT_TRUE(std::ranges::is_sorted(some));
        EXPECT_NEAR(visible_configuration_factor(room.opening, receiver, room.set, some),
                    visible_configuration_factor(room.opening, receiver, room.set, all_of(room.set)), exact);
    }
}

TEST(VisiblePart, hidden_and_visible_light_of_a_split_opening_add_up) {
    Dice dice(9);
    for (int k = 0; k < 400; ++k) {
        const Furnished room = random_room(dice, 12);
        const Receiver receiver{dice.place(1.5), dice.direction(), {}};
        const Polygon& p = room.opening;
        const double s = dice.uniform(0.1, 0.9);
        const Vec3 lower = p[0] + s * (p[1] - p[0]), upper = p[3] + s * (p[2] - p[3]);
        const auto factor = [&](const Polygon& part) {
            return visible_configuration_factor(part, receiver, room.set, all_of(room.set));
        };
        EXPECT_NEAR(factor({p[0], lower, upper, p[3]}) + factor({lower, p[1], p[2], upper}), factor(p), exact);
    }
}

TEST(VisiblePart, a_room_far_from_the_origin_gives_the_same) {
    Dice dice(13);
    const Vec3 far_away{1e5, -7e4, 3e4};
    for (int k = 0; k < 200; ++k) {
        const Furnished room = random_room(dice, 10);
        const Receiver receiver{dice.place(1.5), dice.direction(), {}};
        std::vector<ConvexBody> moved(room.set.bodies().begin(), room.set.bodies().end());
        for (ConvexBody& body : moved) {
            for (Vec3& vertex : body.vertices) vertex += far_away;
        }
        Polygon opening = room.opening;
        for (Vec3& corner : opening) corner += far_away;
        const OccluderSet there(std::move(moved));
        EXPECT_NEAR(visible_configuration_factor(opening, {receiver.position + far_away, receiver.normal, {}}, there,
                                                 all_of(there)),
                    visible_configuration_factor(room.opening, receiver, room.set, all_of(room.set)),
                    1e-8);  // 1.5e-11 m of rounding, seen by edges a centimetre from the eye
    }
}

TEST(VisibleIntervals, a_post_hides_its_shadow_on_a_tube) {
    const OccluderSet set({box_body({-0.1, -0.1, 0}, {0.1, 0.1, 1})});
    const auto seen = visible_intervals({-1, 1, 0.5}, {1, 1, 0.5}, {0, -1, 0.5}, set, all_of(set));
    ASSERT_EQ(seen.size(), 2U);
    const double half_hidden = 0.1 / 0.9 * 2;  // front edge at distance 0.9, tube at 2
    EXPECT_NEAR(seen[0].second, 0.5 - 0.5 * half_hidden, exact);
    EXPECT_NEAR(seen[1].first, 0.5 + 0.5 * half_hidden, exact);
}

TEST(VisiblePart, stacked_and_abutting_boxes_let_no_light_through) {
    Dice dice(43);
    for (int k = 0; k < 200; ++k) {
        const Mat3 turn = dice.rotation();
        const Vec3 at = dice.place(3);
        // Over the eyes, four boxes that meet along edges and faces, turned and moved: rounding parts them.
        std::vector<ConvexBody> bodies{box_body({-5, -5, 1}, {0, 0, 1.5}), box_body({0, -5, 1}, {5, 0, 1.5}),
                                       box_body({-5, 0, 1}, {0, 5, 1.25}), box_body({-5, 0, 1.25}, {0, 5, 1.5}),
                                       box_body({0, 0, 1}, {5, 5, 1.5})};
        for (ConvexBody& body : bodies) {
            for (Vec3& vertex : body.vertices) vertex = turn * vertex + at;
        }
        Polygon opening = facing_down(-1, -1, 1, 1, 3);
        for (Vec3& corner : opening) corner = turn * corner + at;
        const OccluderSet set(std::move(bodies));
        const double x = k % 3 == 0 ? 0.0 : dice.uniform(-1, 1), y = k % 2 == 0 ? 0.0 : dice.uniform(-1, 1);
        const double z = k % 5 == 0 ? 1.0 : dice.uniform(-1, 1);  // also on their lower faces
        EXPECT_LT(visible_share(opening, turn * Vec3{x, y, z} + at, set), 1e-12) << k;
    }
}

TEST(VisibleIntervals, a_tube_is_not_seen_through_the_contact_of_two_boxes) {
    const OccluderSet set({box_body({-1, -1, 0}, {0, 1, 1}), box_body({0, -1, 0}, {1, 1, 1})});
    EXPECT_TRUE(visible_intervals({0, 2, 0.2}, {0, 2, 0.8}, {0, -2, 0.5}, set, all_of(set)).empty());
    // Over the near edge of their tops the eye sees what is 0.5 m up over 1 m, 2 m over 4: above height 2.5.
    const auto seen = visible_intervals({0, 2, 0.5}, {0, 2, 3.5}, {0, -2, 0.5}, set, all_of(set));
    ASSERT_EQ(seen.size(), 1U);
    EXPECT_NEAR(seen[0].first, 2.0 / 3.0, 1e-7);  // found beside the contact, within eight times the distance under which places are one
    EXPECT_EQ(seen[0].second, 1.0);
    const OccluderSet one({box_body({-1, -1, 0}, {0, 1, 1})});
    EXPECT_EQ(visible_intervals({0, 2, 0.2}, {0, 2, 0.8}, {0, -2, 0.5}, one, all_of(one)).size(), 1U);
}

TEST(VisibleIntervals, every_sampled_sight_line_agrees) {
    Dice dice(17);
    int disagreements = 0;
    for (int k = 0; k < 400; ++k) {
        const Furnished room = random_room(dice, 10);
        const Vec3 eye = dice.place(1.2), from = dice.place(2), to = dice.place(2);
        const auto seen = visible_intervals(from, to, eye, room.set, all_of(room.set));
        for (int j = 0; j < 50; ++j) {
            const double t = dice.uniform(0, 1);
            const bool open = !room.set.blocks(eye, from + t * (to - from));
            const auto holds = [&](double margin) {
                return std::ranges::any_of(
                    seen, [&](const auto& part) { return part.first - margin <= t && t <= part.second + margin; });
            };
            if (open ? !holds(1e-7) : holds(-1e-7)) ++disagreements;
        }
    }
    EXPECT_EQ(disagreements, 0);
}

}  // namespace
}  // namespace hanei
