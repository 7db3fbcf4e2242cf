#include "engine/direct/shadow_outline.h"

#include "engine/geometry/polygon.h"
#include "tests/unit/direct/scenes.h"
#include "tests/unit/geometry/shapes.h"

#include <gtest/gtest.h>

namespace hanei {
namespace {

using testing::box_body;
using testing::Dice;
using testing::facing_up;
using testing::luminaire_at;
using testing::panel;
using testing::sheet;

const Scene bare;

Face face_of(const Polygon& outline) {
    Face face;
    face.region.outline = outline;
    face.normal = unit_normal(outline);
    face.along = glm::normalize(outline[1] - outline[0]);
    return face;
}

const Face wide_floor = face_of(facing_up(-5, -5, 5, 5, 0));

double area_of(const std::vector<Polygon>& loops, const Vec3& normal) {
    double area = 0.0;
    for (const Polygon& loop : loops) area += glm::dot(vector_area(loop), normal);
    return area;
}

struct Rectangle {
    Vec2 low{1e9}, high{-1e9};
};

Rectangle around(const std::vector<Polygon>& loops) {
    Rectangle rectangle;
    for (const Polygon& loop : loops) {
        for (const Vec3& corner : loop) {
            rectangle.low = glm::min(rectangle.low, Vec2(corner));
            rectangle.high = glm::max(rectangle.high, Vec2(corner));
        }
    }
    return rectangle;
}

bool holds(const std::vector<Polygon>& loops, const Vec3& normal, const Vec3& place) {
    // Angles of the loops around the place: a turn where it is inside, none where it is outside.
    double turned = 0.0;
    for (const Polygon& loop : loops) {
        for (std::size_t k = 0; k < loop.size(); ++k) {
            const Vec3 a = loop[k] - place, b = loop[(k + 1) % loop.size()] - place;
            turned += std::atan2(glm::dot(glm::cross(a, b), normal), glm::dot(a, b));
        }
    }
    return turned > testing::pi;
}

TEST(ShadowOutline, of_a_square_over_the_floor_is_the_one_on_paper) {
    // Half width s of the opening at height H, b of the square at height h: the umbra reaches to
    // b - (s - b) h / (H - h), the penumbra to b + (s + b) h / (H - h).
    constexpr double s = 0.2, b = 0.5, H = 3.0, h = 1.0;
    const Emitter emitter(bare, luminaire_at({0, 0, H}, panel(2 * s, 2 * s), Luminance{1000}));
    const OccluderSet set({sheet(facing_up(-b, -b, b, b, h), 0)});
    const FaceShadows shadows = shadows_on(wide_floor, {}, emitter, set);
    const double umbra = b - (s - b) * h / (H - h), penumbra = b + (s + b) * h / (H - h);
    ASSERT_EQ(shadows.umbra.size(), 1U);
    ASSERT_EQ(shadows.penumbra.size(), 1U);
    EXPECT_EQ(shadows.umbra[0].size(), 4U);
    EXPECT_EQ(shadows.penumbra[0].size(), 4U);
    constexpr double grid = 1e-7;  // a billionth of the 14 m across the floor, some times
    EXPECT_NEAR(around(shadows.umbra).low.x, -umbra, grid);
    EXPECT_NEAR(around(shadows.umbra).high.y, umbra, grid);
    EXPECT_NEAR(area_of(shadows.umbra, {0, 0, 1}), 4 * umbra * umbra, 10 * grid);
    EXPECT_NEAR(around(shadows.penumbra).low.x, -penumbra, grid);
    EXPECT_NEAR(area_of(shadows.penumbra, {0, 0, 1}), 4 * penumbra * penumbra, 10 * grid);
}

TEST(ShadowOutline, a_small_square_under_a_wide_opening_has_penumbra_only) {
    const Emitter emitter(bare, luminaire_at({0, 0, 3}, panel(1, 1), Luminance{1000}));
    const OccluderSet set({sheet(facing_up(-0.1, -0.1, 0.1, 0.1, 2), 0)});
    const FaceShadows shadows = shadows_on(wide_floor, {}, emitter, set);
    EXPECT_TRUE(shadows.umbra.empty());
    EXPECT_NEAR(around(shadows.penumbra).high.x, 0.1 + 0.6 * 2.0 / 1.0, 1e-7);
}

TEST(ShadowOutline, of_a_point_umbra_and_penumbra_are_one) {
    const Emitter emitter(bare, luminaire_at({0, 0, 2}, PointOpening{}, LuminousFlux{1000}));
    const OccluderSet set({box_body({-0.5, -0.5, 0.5}, {0.5, 0.5, 1})});
    const FaceShadows shadows = shadows_on(wide_floor, {}, emitter, set);
    EXPECT_NEAR(area_of(shadows.umbra, {0, 0, 1}), 4.0, 1e-6);  // from the box's upper edges
    EXPECT_NEAR(area_of(shadows.penumbra, {0, 0, 1}), 4.0, 1e-6);
}

TEST(ShadowOutline, of_a_lamp_below_the_top_of_a_cupboard_runs_on_to_the_walls) {
    const Emitter lamp(bare, luminaire_at({0, 0, 1}, panel(0.2, 0.2), Luminance{1000}));
    const OccluderSet set({box_body({1, -0.5, 0}, {1.5, 0.5, 2})});
    const FaceShadows floor = shadows_on(wide_floor, {}, lamp, set);
    EXPECT_NEAR(around(floor.umbra).high.x, 5, 1e-6);
    EXPECT_NEAR(around(floor.penumbra).high.x, 5, 1e-6);
    const Face wall = face_of({{5, -5, 0}, {5, -5, 4}, {5, 5, 4}, {5, 5, 0}});
    EXPECT_FALSE(shadows_on(wall, {}, Emitter(bare, luminaire_at({0, 0, 1}, PointOpening{}, LuminousFlux{1})), set)
                     .umbra.empty());
}

TEST(ShadowOutline, lines_inside_another_bodys_shadow_vanish) {
    const Emitter emitter(bare, luminaire_at({0, 0, 3}, panel(0.4, 0.4), Luminance{1000}));
    const ConvexBody wide = sheet(facing_up(-1, -1, 1, 1, 1.5), 0);
    const ConvexBody under = sheet(facing_up(-0.2, -0.2, 0.2, 0.2, 1), 0);
    const FaceShadows one = shadows_on(wide_floor, {}, emitter, OccluderSet({wide}));
    const FaceShadows both = shadows_on(wide_floor, {}, emitter, OccluderSet({wide, under}));
    EXPECT_EQ(one.umbra, both.umbra);
    EXPECT_EQ(one.penumbra_lines, both.penumbra_lines);
}

TEST(ShadowOutline, where_furniture_stands_there_is_none) {
    const Emitter emitter(bare, luminaire_at({2, 0, 3}, panel(0.4, 0.4), Luminance{1000}));
    const OccluderSet set({box_body({-0.5, -0.5, 0}, {0.5, 0.5, 1})});
    const std::vector<Polygon> foot{facing_up(-0.5, -0.5, 0.5, 0.5, 0)};
    const FaceShadows shadows = shadows_on(wide_floor, foot, emitter, set);
    EXPECT_FALSE(holds(shadows.umbra, {0, 0, 1}, {0, 0, 0}));
    EXPECT_TRUE(holds(shadows.umbra, {0, 0, 1}, {-0.51, 0, 0}));
    EXPECT_NEAR(area_of(shadows_on(wide_floor, {}, emitter, set).umbra, {0, 0, 1}) - area_of(shadows.umbra, {0, 0, 1}),
                1.0, 1e-6);
}

TEST(ShadowOutline, a_bodys_own_faces_and_faces_behind_the_opening_have_none) {
    const Emitter emitter(bare, luminaire_at({0, 0, 3}, panel(0.4, 0.4), Luminance{1000}));
    const OccluderSet set({box_body({-0.5, -0.5, 0}, {0.5, 0.5, 1})});
    EXPECT_TRUE(shadows_on(face_of(facing_up(-0.5, -0.5, 0.5, 0.5, 1)), {}, emitter, set).penumbra.empty());
    EXPECT_TRUE(shadows_on(face_of(facing_up(-5, -5, 5, 5, 3.5)), {}, emitter, set).penumbra.empty());
}

/// What the luminaire gives a place, as a share of what it would without bodies.
double visible_share(const Emitter& emitter, const OccluderSet& set, const Vec3& place, const Vec3& normal) {
    const double open = emitter.illuminance({place, normal, Vec3{0}}, nullptr).value;
    return open > 0.0 ? emitter.illuminance({place, normal, Vec3{0}}, &set).value / open : -1.0;
}

TEST(ShadowOutline, places_beside_it_have_the_light_it_says) {
    PolyhedronOpening cube;
    const ConvexBody shape = box_body({-0.2, -0.15, -0.1}, {0.2, 0.15, 0.1});
    cube.vertices = shape.vertices, cube.faces = shape.faces;
    const std::vector<Opening> openings{panel(0.5, 0.3), cube, PointOpening{}, LineOpening{}};
    int sides = 0;
    for (int seed = 0; seed < 60; ++seed) {
        Dice dice(static_cast<std::uint64_t>(seed));
        Luminaire light = luminaire_at({dice.uniform(-1, 1), dice.uniform(-1, 1), dice.uniform(1.2, 3)},
                                       openings[static_cast<std::size_t>(seed % 4)], LuminousFlux{1000});
        light.yaw = dice.uniform(0, 3);
        light.tilt = seed % 8 < 4 ? 0.0 : dice.uniform(-1, 1);
        const Vec3 low{dice.uniform(-2, 1), dice.uniform(-2, 1), dice.uniform(0, 0.8)};
        const OccluderSet set(
            {box_body(low, low + Vec3{dice.uniform(0.1, 1), dice.uniform(0.1, 1), dice.uniform(0.1, 1.5)})});
        const Emitter emitter(bare, light);
        for (const Face& face : {wide_floor, face_of({{3, -5, 0}, {3, -5, 4}, {3, 5, 4}, {3, 5, 0}})}) {
            const FaceShadows shadows = shadows_on(face, {}, emitter, set);
            for (const bool umbra : {true, false}) {
                for (const Polygon& line : umbra ? shadows.umbra_lines : shadows.penumbra_lines) {
                    for (std::size_t k = 0; k + 1 < line.size(); ++k) {
                        const Vec3 side = line[k + 1] - line[k];
                        if (glm::length(side) < 0.05) continue;
                        const Vec3 across = glm::normalize(glm::cross(face.normal, side));
                        const Vec3 middle = 0.5 * (line[k] + line[k + 1]);
                        const bool left =
                            holds(umbra ? shadows.umbra : shadows.penumbra, face.normal, middle + 1e-5 * across);
                        const Vec3 in = middle + (left ? 1e-4 : -1e-4) * across,
                                   out = middle - (left ? 1e-4 : -1e-4) * across;
                        if (set.containing(in + 1e-6 * face.normal) >= 0 ||
                            set.containing(out + 1e-6 * face.normal) >= 0)
                            continue;
                        const double inside = visible_share(emitter, set, in, face.normal);
                        const double outside = visible_share(emitter, set, out, face.normal);
                        if (inside < 0.0 || outside < 0.0) continue;  // behind the opening
                        ++sides;
                        if (umbra) {
                            EXPECT_EQ(inside, 0.0) << seed;
                            EXPECT_GT(outside, 0.0) << seed;
                        } else {
                            EXPECT_LT(inside, 1.0) << seed;
                            EXPECT_EQ(outside, 1.0) << seed;
                        }
                    }
                }
            }
        }
    }
    EXPECT_GT(sides, 200);
}

TEST(ShadowOutline, among_many_bodies_all_places_have_the_light_it_says) {
    Dice dice(77);
    std::vector<ConvexBody> bodies;
    for (int k = 0; k < 25; ++k) {
        const Vec3 low{dice.uniform(-4, 3.5), dice.uniform(-4, 3.5), k % 3 == 0 ? dice.uniform(0, 1) : 0.0};
        bodies.push_back(box_body(low, low + Vec3{dice.uniform(0.1, 1), dice.uniform(0.1, 1), dice.uniform(0.1, 1)}));
    }
    const OccluderSet set(bodies);
    const Emitter emitter(bare, luminaire_at({0.3, 0.2, 2.5}, panel(1.2, 0.6), Luminance{1000}));
    const FaceShadows shadows = shadows_on(wide_floor, {}, emitter, set);
    int in_penumbra = 0;
    for (int k = 0; k < 5000; ++k) {
        const Vec3 place{dice.uniform(-5, 5), dice.uniform(-5, 5), 0};
        if (set.containing(place + Vec3{0, 0, 1e-6}) >= 0) continue;
        const double share = visible_share(emitter, set, place, {0, 0, 1});
        if (holds(shadows.umbra, {0, 0, 1}, place)) {
            EXPECT_EQ(share, 0.0);
        }
        if (holds(shadows.penumbra, {0, 0, 1}, place)) {
            EXPECT_LT(share, 1.0);
            ++in_penumbra;
        } else {
            EXPECT_EQ(share, 1.0);
        }
    }
    EXPECT_GT(in_penumbra, 1000);
}

TEST(ShadowOutline, without_bodies_or_light_there_is_none) {
    const Emitter emitter(bare, luminaire_at({0, 0, 3}, panel(0.4, 0.4), Luminance{1000}));
    EXPECT_TRUE(shadows_on(wide_floor, {}, emitter, OccluderSet()).penumbra.empty());
    const Emitter dark(bare, luminaire_at({0, 0, 3}, PointOpening{}, LuminousFlux{0}));
    EXPECT_TRUE(shadows_on(wide_floor, {}, dark, OccluderSet({box_body({0, 0, 1}, {1, 1, 2})})).penumbra.empty());
}

}  // namespace
}  // namespace hanei
