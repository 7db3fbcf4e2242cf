#include "engine/direct/light_class.h"

#include "tests/unit/direct/scenes.h"
#include "tests/unit/geometry/shapes.h"

#include <gtest/gtest.h>

namespace hanei {
namespace {

using testing::box_body;
using testing::Dice;
using testing::facing_down;
using testing::facing_up;
using testing::luminaire_at;
using testing::panel;
using testing::pi;
using testing::sheet;

const Scene bare;

ConvexBody turned(ConvexBody body, const Vec3& about, const Mat3& rotation) {
    for (Vec3& vertex : body.vertices) vertex = about + rotation * (vertex - about);
    return body;
}

/// Boxes of furniture's sizes standing on the floor, on each other and in the air, one in three turned.
std::vector<ConvexBody> boxes(Dice& dice, int count) {
    std::vector<ConvexBody> bodies;
    for (int k = 0; k < count; ++k) {
        const Vec3 size{dice.uniform(0.05, 1.2), dice.uniform(0.05, 1.0), dice.uniform(0.03, 1.4)};
        const bool stands = k % 4 != 0;
        const Vec3 low{dice.uniform(-3, 3 - size.x), dice.uniform(-2, 2 - size.y),
                       stands ? 0.0 : dice.uniform(0.3, 2.0)};
        ConvexBody body = box_body(low, low + size);
        if (k % 3 == 0) {
            const double angle = dice.uniform(0, pi);
            const Mat3 about_z{
                {std::cos(angle), std::sin(angle), 0}, {-std::sin(angle), std::cos(angle), 0}, {0, 0, 1}};
            body = turned(body, low + 0.5 * size, about_z);
        }
        bodies.push_back(body);
    }
    return bodies;
}

struct Truth {
    bool all_lit = true, none_lit = true;
};

/// Dense points of a parallelogram, its border a thousandth inside.
Truth truth_of(const Polygon& patch, const Vec3& normal, const Emitter& emitter, const OccluderSet& occluders, int n) {
    Truth truth;
    for (int i = 0; i < n; ++i) {
        for (int j = 0; j < n; ++j) {
            const double u = 0.001 + 0.998 * i / (n - 1), v = 0.001 + 0.998 * j / (n - 1);
            const Receiver at{patch[0] + u * (patch[1] - patch[0]) + v * (patch[3] - patch[0]), normal, Vec3{0}};
            const double open = emitter.illuminance(at, nullptr).value;
            const double here = emitter.illuminance(at, &occluders).value;
            truth.all_lit = truth.all_lit && std::abs(here - open) <= 1e-9 * open;
            truth.none_lit = truth.none_lit && here == 0.0;
        }
    }
    return truth;
}

std::vector<Luminaire> every_kind_of_luminaire() {
    std::vector<Luminaire> lights;
    lights.push_back(luminaire_at({1, 0.5, 2.7}, panel(1.2, 0.6), Luminance{4000}));
    lights.push_back(luminaire_at({-1, -0.4, 2.6}, PointOpening{}, LuminousFlux{3000}));
    lights.push_back(luminaire_at({0.3, 0, 2.5}, LineOpening{}, LuminousFlux{3000}));
    PolyhedronOpening solid;
    const ConvexBody cube = box_body({-0.2, -0.15, -0.1}, {0.2, 0.15, 0.1});
    solid.vertices = cube.vertices;
    solid.faces = cube.faces;
    lights.push_back(luminaire_at({-0.5, 0.8, 2.2}, solid, LuminousFlux{3000}));
    Luminaire spot = luminaire_at({1.5, -1, 2.0}, PointOpening{}, LuminousFlux{3000});
    spot.distribution = CosinePower{4};
    spot.tilt = 0.7;
    lights.push_back(spot);
    const PolygonOpening angle{{{{0, 0, 0}, {0, 1, 0}, {0.3, 1, 0}, {0.3, 0.3, 0}, {1, 0.3, 0}, {1, 0, 0}}, {}}};
    Luminaire wall = luminaire_at({-2.9, 0, 1.2}, angle, Luminance{2000});
    wall.roll = 1.1;
    lights.push_back(wall);
    return lights;
}

TEST(LightClass, is_never_wrong_for_any_patch_and_any_kind_of_luminaire) {
    const std::vector<Luminaire> lights = every_kind_of_luminaire();
    int proved = 0, pairs = 0;
    for (const int count : {3, 10, 40, 150, 600}) {
        Dice dice(static_cast<std::uint64_t>(count));
        const OccluderSet occluders(boxes(dice, count));
        for (const Luminaire& light : lights) {
            const Emitter emitter(bare, light);
            for (int k = 0; k < 120; ++k) {
                const Mat3 frame = k % 2 == 0 ? Mat3(1.0) : dice.rotation();
                const Vec3 place{dice.uniform(-3, 2.7), dice.uniform(-2, 1.7), k % 2 == 0 ? 0.0 : dice.uniform(0, 2.7)};
                const double width = dice.uniform(0.02, 0.4);
                const Vec3 a = width * frame[0], b = dice.uniform(0.02, 0.4) * frame[1];
                const Polygon patch{place, place + a, place + a + b, place + b};
                std::vector<BodyIndex> between;
                const LightClass kind =
                    classify({patch, frame[2]}, emitter, &occluders, std::nullopt, between, {k % 5 - 1});
                ++pairs;
                if (kind == LightClass::partly) continue;
                ++proved;
                const Truth truth = truth_of(patch, frame[2], emitter, occluders, 9);
                if (kind == LightClass::lit)
                    EXPECT_TRUE(truth.all_lit) << count << " boxes, luminaire " << &light - lights.data() << ", " << k;
                else
                    EXPECT_TRUE(truth.none_lit) << count << " boxes, luminaire " << &light - lights.data() << ", " << k;
            }
        }
    }
    EXPECT_GT(proved, pairs / 2);
}

/// Shares of the pairs of 0.25 m floor patches and two ceiling panels.
struct Shares {
    int lit = 0, unlit = 0, truly_lit = 0, truly_unlit = 0;
};

Shares shares_among(int count, int halvings) {
    Dice dice(static_cast<std::uint64_t>(count) + 5);
    const OccluderSet occluders(boxes(dice, count));
    Shares shares;
    for (const double x : {-1.5, 1.5}) {
        const Emitter emitter(bare, luminaire_at({x, 0, 2.8}, panel(1.2, 0.6), Luminance{4000}));
        for (int k = 0; k < 24 * 16; ++k) {
            const Polygon patch = facing_up(-3 + 0.25 * (k % 24), -2 + 0.25 * (k / 24), -2.75 + 0.25 * (k % 24),
                                            -1.75 + 0.25 * (k / 24), 0);
            const Truth truth = truth_of(patch, {0, 0, 1}, emitter, occluders, 7);
            std::vector<BodyIndex> between;
            const LightClass kind =
                classify({patch, {0, 0, 1}}, emitter, &occluders, std::nullopt, between, {halvings});
            shares.lit += kind == LightClass::lit;
            shares.unlit += is_unlit(kind);
            shares.truly_lit += truth.all_lit;
            shares.truly_unlit += truth.none_lit;
        }
    }
    return shares;
}

TEST(LightClass, proves_nearly_all_of_what_dense_points_find_uniform) {
    for (const int count : {10, 40, 150, 600}) {
        const Shares shares = shares_among(count, 3);
        // 9 points may miss a thin shadow that the proof knows of, hardly more.
        EXPECT_GE(shares.lit, shares.truly_lit - 2) << count;
        EXPECT_LE(shares.lit, shares.truly_lit) << count;
        EXPECT_GE(shares.unlit, 0.93 * shares.truly_unlit) << count;  // measured 0.94 to 0.99
        EXPECT_LE(shares.unlit, shares.truly_unlit) << count;
    }
}

TEST(LightClass, one_body_at_a_time_proves_most_umbrae_and_several_prove_more) {
    const Shares single = shares_among(150, ClassEffort::single_bodies);
    const Shares together = shares_among(150, 2);
    EXPECT_GE(single.unlit, 0.8 * single.truly_unlit);
    EXPECT_GT(together.unlit, single.unlit);
    EXPECT_EQ(together.lit, single.lit);
}

LightClass class_of(const Polygon& patch, const Vec3& normal, const Luminaire& light, const OccluderSet* occluders,
                    int halvings = 0) {
    std::vector<BodyIndex> between;
    return classify({patch, normal}, Emitter(bare, light), occluders, std::nullopt, between, {halvings});
}

TEST(LightClass, boxes_side_by_side_hide_together_what_none_hides_alone) {
    const OccluderSet row({box_body({-1, -1, 1}, {0, 1, 1.1}), box_body({0, -1, 1}, {1, 1, 1.1})});
    const Luminaire light = luminaire_at({0, 0, 2.5}, panel(0.4, 0.4), Luminance{4000});
    const Polygon patch = facing_up(-0.1, -0.1, 0.1, 0.1, 0);
    EXPECT_EQ(class_of(patch, {0, 0, 1}, light, &row), LightClass::umbra);
    EXPECT_EQ(class_of(patch, {0, 0, 1}, light, &row, ClassEffort::single_bodies), LightClass::partly);
    const OccluderSet gap({box_body({-1, -1, 1}, {-0.001, 1, 1.1}), box_body({0, -1, 1}, {1, 1, 1.1})});
    EXPECT_EQ(class_of(patch, {0, 0, 1}, light, &gap, 4), LightClass::partly);  // a millimetre between them
}

TEST(LightClass, what_faces_away_is_away_whatever_stands_between) {
    const Luminaire light = luminaire_at({0, 0, 2.5}, panel(0.4, 0.4), Luminance{4000});
    const OccluderSet roof({box_body({-1, -1, 1}, {1, 1, 1.1})});
    for (const OccluderSet* occluders : {static_cast<const OccluderSet*>(nullptr), &roof}) {
        EXPECT_EQ(class_of(facing_down(-1, -1, 1, 1, 0.5), {0, 0, -1}, light, occluders), LightClass::away);
        EXPECT_EQ(class_of(facing_down(-1, -1, 1, 1, 2.5), {0, 0, -1}, light, occluders), LightClass::away);
        EXPECT_EQ(class_of(facing_up(-1, -1, 1, 1, 3), {0, 0, 1}, light, occluders), LightClass::away);
    }
}

TEST(LightClass, a_patch_cut_by_the_openings_plane_is_judged_by_its_lit_part) {
    const Luminaire light = luminaire_at({0, 0, 2.5}, panel(0.4, 0.4), Luminance{4000});
    const Polygon wall{{1, -0.2, 2}, {1, 0.2, 2}, {1, 0.2, 3}, {1, -0.2, 3}};
    const OccluderSet above({box_body({0.4, -1, 2.6}, {0.6, 1, 2.8})});
    EXPECT_EQ(class_of(wall, {-1, 0, 0}, light, &above), LightClass::lit);
    const OccluderSet below({box_body({0.4, -1, 1.5}, {0.6, 1, 2.6})});
    EXPECT_EQ(class_of(wall, {-1, 0, 0}, light, &below), LightClass::umbra);
}

TEST(LightClass, the_foot_of_a_cupboard_is_lit_up_to_its_edge) {
    const OccluderSet cupboard({box_body({0, 0, 0}, {1, 0.5, 2})});
    const Luminaire light = luminaire_at({0.5, 2, 2.5}, panel(0.4, 0.4), Luminance{4000});
    EXPECT_EQ(class_of(facing_up(0, 0.5, 1, 1, 0), {0, 0, 1}, light, &cupboard), LightClass::lit);
    EXPECT_EQ(class_of(facing_up(0.3, -0.3, 0.7, 0, 0), {0, 0, 1}, light, &cupboard), LightClass::umbra);
    EXPECT_EQ(class_of(facing_up(-0.5, -0.4, 0, 0, 0), {0, 0, 1}, light, &cupboard), LightClass::partly);
}

TEST(LightClass, a_luminaires_own_body_hides_nothing_of_it) {
    const Luminaire light = luminaire_at({0, 0, 2.5}, panel(0.4, 0.4), Luminance{4000});
    const OccluderSet own({sheet({{-1, -1, 2}, {1, -1, 2}, {1, 1, 2}, {-1, 1, 2}}, light.id.value)});
    EXPECT_EQ(class_of(facing_up(-0.2, -0.2, 0.2, 0.2, 0), {0, 0, 1}, light, &own), LightClass::lit);
}

TEST(LightClass, without_light_or_area_it_is_away) {
    EXPECT_EQ(class_of(facing_up(0, 0, 1, 1, 0), {0, 0, 1}, luminaire_at({0, 0, 2}, PointOpening{}, LuminousFlux{0}),
                       nullptr),
              LightClass::away);
    const Luminaire light = luminaire_at({0, 0, 2.5}, panel(0.4, 0.4), Luminance{4000});
    EXPECT_EQ(class_of({}, {0, 0, 1}, light, nullptr), LightClass::away);
}

TEST(LightClass, of_two_luminaires_the_one_that_faces_the_patch_decides) {
    EXPECT_EQ(together(LightClass::away, LightClass::lit), LightClass::lit);
    EXPECT_EQ(together(LightClass::umbra, LightClass::away), LightClass::umbra);
    EXPECT_EQ(together(LightClass::umbra, LightClass::lit), LightClass::partly);
    EXPECT_EQ(together(LightClass::lit, LightClass::lit), LightClass::lit);
}

TEST(LightClass, the_same_classes_on_one_thread_and_on_seven) {
    Dice dice(11);
    const OccluderSet occluders(boxes(dice, 40));
    const Emitter emitter(bare, luminaire_at({1, 0.5, 2.7}, panel(1.2, 0.6), Luminance{4000}));
    std::vector<Polygon> outlines;
    for (int k = 0; k < 300; ++k) {
        const double x = -3 + 0.3 * (k % 20), y = -2 + 0.26 * (k / 20);
        outlines.push_back(facing_up(x, y, x + 0.3, y + 0.26, 0));
    }
    std::vector<ReceivingPolygon> patches;
    for (const Polygon& outline : outlines) patches.push_back({outline, {0, 0, 1}});
    EXPECT_EQ(light_classes(patches, emitter, &occluders, Work{.threads = 1}),
              light_classes(patches, emitter, &occluders, Work{.threads = 7}));
}

}  // namespace
}  // namespace hanei
