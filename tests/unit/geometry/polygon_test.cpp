#include "engine/geometry/polygon.h"

#include "tests/unit/geometry/shapes.h"

#include <cmath>
#include <gtest/gtest.h>
#include <numbers>

namespace hanei {
namespace {

using testing::Dice;
using testing::facing_down;
using testing::facing_up;

double area_of(const std::vector<Polygon>& pieces, const Vec3& normal) {
    double sum = 0;
    for (const Polygon& piece : pieces) sum += glm::dot(vector_area(piece), normal);
    return sum;
}

const Vec3 up{0, 0, 1};

TEST(Polygon, area_normal_and_centroid_of_a_rectangle) {
    const Polygon table = facing_up(1, 2, 4, 4, 0.7);
    EXPECT_EQ(vector_area(table), Vec3(0, 0, 6));
    EXPECT_EQ(unit_normal(table), up);
    EXPECT_NEAR(glm::distance(centroid(table), Vec3(2.5, 3, 0.7)), 0, 1e-15);
    EXPECT_NEAR(diameter(table), std::hypot(3, 2), 1e-15);
    EXPECT_EQ(unit_normal(facing_down(1, 2, 4, 4, 0.7)), -up);
}

TEST(Polygon, a_concave_outline_has_the_centroid_of_its_parts) {
    const Polygon corner = {{0, 0, 0}, {2, 0, 0}, {2, 1, 0}, {1, 1, 0}, {1, 2, 0}, {0, 2, 0}};
    EXPECT_NEAR(vector_area(corner).z, 3, 1e-15);
    EXPECT_NEAR(glm::distance(centroid(corner), Vec3(2.5 / 3, 2.5 / 3, 0)), 0, 1e-15);
    EXPECT_FALSE(is_convex(corner, up));
    EXPECT_TRUE(is_convex(facing_up(0, 0, 1, 1, 0), up));
}

TEST(Polygon, without_area_there_is_no_normal) {
    EXPECT_EQ(unit_normal(Polygon{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}}), Vec3(0.0));
    EXPECT_EQ(unit_normal(Polygon{}), Vec3(0.0));
    EXPECT_NE(unit_normal(Polygon{{0, 0, 0}, {1, 0, 0}, {1, 1e-6, 0}}), Vec3(0.0));  // a sliver has one
}

TEST(Polygon, a_bent_sheet_is_not_planar) {
    EXPECT_EQ(distance_from_plane(facing_up(0, 0, 1, 1, 5)), 0.0);
    EXPECT_NEAR(distance_from_plane(Polygon{{0, 0, 0.1}, {1, 0, -0.1}, {1, 1, 0.1}, {0, 1, -0.1}}), 0.1, 1e-15);
}

TEST(Polygon, outlines_that_cross_or_touch_themselves_are_not_simple) {
    using Outline = std::vector<Vec2>;
    EXPECT_TRUE(is_simple(Outline{{0, 0}, {1, 0}, {1, 1}, {0, 1}}));
    EXPECT_TRUE(is_simple(Outline{{0, 0}, {1, 0}, {2, 0}, {2, 1}}));           // a straight corner
    EXPECT_FALSE(is_simple(Outline{{0, 0}, {1, 1}, {1, 0}, {0, 1}}));          // a bow tie
    EXPECT_FALSE(is_simple(Outline{{0, 0}, {2, 0}, {2, 2}, {1, 0}, {0, 2}}));  // touches its own edge
    EXPECT_FALSE(is_simple(Outline{{0, 0}, {2, 0}, {1, 0}, {1, 1}}));          // turns back
    EXPECT_FALSE(is_simple(Outline{{0, 0}, {1, 0}, {1, 0}, {0, 1}}));          // a point twice
    EXPECT_FALSE(is_simple(Outline{{0, 0}, {1, 0}}));
}

TEST(Polygon, clipping_keeps_the_front_of_the_plane) {
    const Polygon half = clipped(facing_up(0, 0, 2, 1, 0), {{0.5, 0, 0}, {1, 0, 0}}, 1e-12);
    EXPECT_NEAR(vector_area(half).z, 1.5, 1e-15);
    EXPECT_TRUE(clipped(facing_up(0, 0, 2, 1, 0), {{2, 0, 0}, {1, 0, 0}}, 1e-12).empty());
    EXPECT_EQ(clipped(facing_up(0, 0, 2, 1, 0), {{0, 0, 0}, {1, 0, 0}}, 1e-12), facing_up(0, 0, 2, 1, 0));
}

TEST(Polygon, what_is_cut_out_and_what_is_left_add_up) {
    Dice dice(2);
    for (int k = 0; k < 300; ++k) {
        const double x = dice.uniform(-2, 2), y = dice.uniform(-2, 2);
        const Polygon whole = facing_up(-1, -1, 1, 1, 3);
        const Polygon cutter = facing_up(x, y, x + dice.uniform(0.1, 3), y + dice.uniform(0.1, 3), 3);
        Polygon inside;
        const auto left = subtracted(whole, cutter, 1e-9, &inside);
        EXPECT_NEAR(area_of(left, up) + vector_area(inside).z, 4, 1e-14);
        const double wide = std::min(1.0, cutter[1].x) - std::max(-1.0, x);
        const double high = std::min(1.0, cutter[2].y) - std::max(-1.0, y);
        EXPECT_NEAR(vector_area(inside).z, std::max(0.0, wide) * std::max(0.0, high), 1e-14);
        for (const Polygon& piece : left) EXPECT_TRUE(is_convex(piece, up));
    }
}

TEST(Polygon, a_cutter_beside_leaves_the_whole_in_one_piece) {
    const Polygon whole = facing_up(0, 0, 1, 1, 0);
    EXPECT_EQ(subtracted(whole, facing_up(1, 0, 2, 1, 0), 1e-9), std::vector<Polygon>{whole});
    EXPECT_EQ(subtracted(whole, facing_up(1.5, 1.5, 2, 2, 0), 1e-9), std::vector<Polygon>{whole});
    EXPECT_TRUE(subtracted(whole, facing_up(-1, -1, 2, 2, 0), 1e-9).empty());
}

void expect_convex_cover(const Region& region) {
    const Vec3 normal = unit_normal(region.outline);
    const auto pieces = convex_pieces(region);
    ASSERT_FALSE(pieces.empty());
    EXPECT_NEAR(area_of(pieces, normal), glm::dot(vector_area(region), normal), 1e-13);
    for (const Polygon& piece : pieces) EXPECT_TRUE(is_convex(piece, normal));
    for (std::size_t k = 0; k < pieces.size(); ++k) {  // no two overlap
        for (std::size_t j = k + 1; j < pieces.size(); ++j) {
            Polygon both;
            subtracted(pieces[k], pieces[j], 1e-9, &both);
            EXPECT_TRUE(both.empty()) << k << " and " << j;
        }
    }
}

TEST(ConvexPieces, a_convex_outline_is_its_own_piece) {
    EXPECT_EQ(convex_pieces({facing_up(0, 0, 1, 1, 0), {}}), std::vector<Polygon>{facing_up(0, 0, 1, 1, 0)});
    EXPECT_TRUE(convex_pieces({Polygon{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}}, {}}).empty());
}

TEST(ConvexPieces, an_l_shaped_plan_falls_into_two) {
    const Region plan{{{0, 0, 0}, {2, 0, 0}, {2, 1, 0}, {1, 1, 0}, {1, 2, 0}, {0, 2, 0}}, {}};
    expect_convex_cover(plan);
    EXPECT_EQ(convex_pieces(plan).size(), 2U);
}

TEST(ConvexPieces, holes_stay_empty) {
    expect_convex_cover({facing_up(0, 0, 4, 4, 1), {facing_down(1, 1, 2, 2, 1)}});
    expect_convex_cover({facing_up(0, 0, 4, 4, 1), {facing_down(1, 1, 2, 2, 1), facing_down(2.5, 1, 3, 3, 1)}});
    expect_convex_cover({facing_up(0, 0, 9, 3, 1),
                         {facing_down(1, 1, 2, 2, 1), facing_down(3, 1, 4, 2, 1), facing_down(5, 1, 6, 2, 1),
                          facing_down(7, 1, 8, 2, 1)}});
    const Polygon triangular_hole = {{1, 1, 0}, {1.5, 2.5, 0}, {2.5, 1.2, 0}};
    expect_convex_cover({{{0, 0, 0}, {4, 0.5, 0}, {3.5, 4, 0}, {2, 3, 0}, {0.2, 3.7, 0}}, {triangular_hole}});
}

TEST(ConvexPieces, stars_in_any_position_are_covered) {
    Dice dice(4);
    for (int k = 0; k < 100; ++k) {
        const Mat3 turn = dice.rotation();
        const Vec3 shift = dice.place(10);
        Region star;
        const int points = 5 + k % 9;
        for (int j = 0; j < 2 * points; ++j) {
            const double angle = std::numbers::pi * j / points;
            const double radius = j % 2 == 0 ? dice.uniform(0.8, 1.2) : dice.uniform(0.2, 0.7);
            star.outline.push_back(shift + turn * (radius * Vec3{std::cos(angle), std::sin(angle), 0}));
        }
        expect_convex_cover(star);
    }
}

}  // namespace
}  // namespace hanei
