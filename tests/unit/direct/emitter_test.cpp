#include "tests/unit/direct/scenes.h"

#include <gtest/gtest.h>
#include <limits>

namespace hanei {
namespace {

using testing::floor_point;
using testing::luminaire_at;
using testing::panel;
using testing::pi;
using testing::sheet;

const Scene bare;

double lux(const Luminaire& luminaire, const Receiver& receiver, const OccluderSet* occluders = nullptr) {
    return Emitter(bare, luminaire).illuminance(receiver, occluders).value;
}

TEST(PointSource, doubling_the_distance_quarters_the_illuminance) {
    const Luminaire lamp = luminaire_at({0, 0, 2}, PointOpening{}, LuminousFlux{1200});
    EXPECT_NEAR(lux(lamp, floor_point(0, 0)), 1200 / (4 * pi) / 4, 1e-13);
    const Luminaire higher = luminaire_at({0, 0, 4}, PointOpening{}, LuminousFlux{1200});
    EXPECT_NEAR(lux(lamp, floor_point(0, 0)) / lux(higher, floor_point(0, 0)), 4, 1e-14);
    EXPECT_NEAR(lux(lamp, floor_point(2, 0)), 1200 / (4 * pi) / 8 * std::sqrt(0.5), 1e-13);
    EXPECT_EQ(Emitter(bare, lamp).flux().value, 1200);
    EXPECT_EQ(Emitter(bare, lamp).luminaire(), lamp.id);
}

TEST(PointSource, a_cosine_beam_follows_its_tilt) {
    Luminaire lamp = luminaire_at({0, 0, 3}, PointOpening{}, LuminousFlux{1000});
    lamp.distribution = CosinePower{4};
    const double peak = 1000 * 5 / (2 * pi);
    EXPECT_NEAR(lux(lamp, floor_point(0, 0)), peak / 9, 1e-12);
    EXPECT_EQ(lux(lamp, {{0, 0, 5}, {0, 0, -1}, {}}), 0.0);  // nothing above its horizon
    lamp.tilt = pi / 4;                                      // turns nadir towards +x
    EXPECT_NEAR(lux(lamp, floor_point(3, 0)), peak / 18 * std::sqrt(0.5), 1e-12);
    lamp.yaw = pi / 2;
    EXPECT_NEAR(lux(lamp, floor_point(0, 3)), peak / 18 * std::sqrt(0.5), 1e-12);
}

TEST(PointSource, its_shadow_is_hard_and_a_point_on_the_very_edge_is_lit) {
    const Luminaire lamp = luminaire_at({0, 0, 2}, PointOpening{}, LuminousFlux{1000});
    const OccluderSet set({sheet({{0.5, -1, 1}, {2, -1, 1}, {2, 1, 1}, {0.5, 1, 1}})});
    EXPECT_EQ(lux(lamp, floor_point(1.000001, 0), &set), 0.0);
    EXPECT_EQ(lux(lamp, floor_point(0.999999, 0), &set), lux(lamp, floor_point(0.999999, 0)));
    EXPECT_EQ(lux(lamp, floor_point(1, 0), &set), lux(lamp, floor_point(1, 0)));
}

TEST(PointSource, a_receiver_in_the_lamp_itself_gets_no_infinite_light) {
    const Luminaire lamp = luminaire_at({0, 0, 0}, PointOpening{}, LuminousFlux{1000});
    EXPECT_EQ(lux(lamp, floor_point(0, 0)), 0.0);
}

/// The tube cut into short pieces, each a point: the definition, summed.
double summed_tube(const Vec3& from, const Vec3& to, double flux, const Receiver& receiver) {
    const int pieces = 20'000;
    const double length = glm::distance(from, to);
    const Vec3 along = (to - from) / length;
    double sum = 0;
    for (int k = 0; k < pieces; ++k) {
        const Vec3 seen = from + ((k + 0.5) / pieces) * (to - from) - receiver.position;
        const double distance = glm::length(seen);
        const double sine = glm::length(glm::cross(seen, along)) / distance;
        sum += sine * std::max(0.0, glm::dot(seen, receiver.normal)) / (distance * distance * distance);
    }
    return sum * flux / (pi * pi * length) * length / pieces;
}

TEST(LineSource, a_tube_is_the_sum_of_its_elements) {
    const Vec3 from{-0.6, 0.1, 2.3}, to{0.9, -0.3, 2.6};
    const Luminaire tube = luminaire_at({0, 0, 0}, LineOpening{from, to}, LuminousFlux{3000});
    for (const Receiver& receiver :
         {floor_point(0, 0), floor_point(2, -1), Receiver{{0.5, 2, 1}, glm::normalize(Vec3{0.2, -1, 0.1}), {}},
          Receiver{{3, 0, 2.5}, glm::normalize(Vec3{-1, 0.1, -0.2}), {}}}) {
        const double expected = summed_tube(from, to, 3000, receiver);
        EXPECT_NEAR(lux(tube, receiver) / expected, 1, 1e-7);  // 20,000 midpoints
    }
}

TEST(LineSource, an_endless_tube_falls_off_with_the_distance) {
    const Luminaire tube =
        luminaire_at({0, 0, 0}, LineOpening{{-5000, 0, 2}, {5000, 0, 2}}, LuminousFlux{pi * pi * 1e4});
    EXPECT_NEAR(lux(tube, floor_point(0, 0)), pi / 2 / 2, 1e-6);  // I1 pi / (2 h), I1 = 1; the ends miss (h/s)^3
}

TEST(LineSource, on_its_own_axis_a_tube_gives_nothing) {
    const Luminaire tube = luminaire_at({0, 0, 0}, LineOpening{{0, 0, 1}, {0, 0, 2}}, LuminousFlux{1000});
    EXPECT_EQ(lux(tube, floor_point(0, 0)), 0.0);
    EXPECT_EQ(lux(tube, {{0, 0, 1.5}, {0, 0, 1}, {}}), 0.0);
}

TEST(LineSource, a_shelf_that_hides_half_a_tube_leaves_the_other_half) {
    const Luminaire tube = luminaire_at({0, 0, 2}, LineOpening{{-1, 0, 0}, {1, 0, 0}}, LuminousFlux{2000});
    const Luminaire half = luminaire_at({0, 0, 2}, LineOpening{{-1, 0, 0}, {0, 0, 0}}, LuminousFlux{1000});
    const OccluderSet set({sheet({{0, -1, 1}, {3, -1, 1}, {3, 1, 1}, {0, 1, 1}})});
    EXPECT_NEAR(lux(tube, floor_point(0, 0), &set), lux(half, floor_point(0, 0)), 1e-12);
}

TEST(DiffuseSource, flux_and_luminance_of_a_panel_say_the_same) {
    const Luminaire by_flux = luminaire_at({0, 0, 2.5}, panel(1.2, 0.6), LuminousFlux{pi * 5000 * 0.72});
    const Luminaire by_luminance = luminaire_at({0, 0, 2.5}, panel(1.2, 0.6), Luminance{5000});
    EXPECT_NEAR(lux(by_flux, floor_point(1, 1)), lux(by_luminance, floor_point(1, 1)), 1e-12);
    EXPECT_NEAR(Emitter(bare, by_luminance).flux().value, pi * 5000 * 0.72, 1e-9);
    EXPECT_NEAR(lux(by_luminance, floor_point(0, 0)),
                5000 * pi *
                    configuration_factor(Polygon{{-.6, -.3, 2.5}, {-.6, .3, 2.5}, {.6, .3, 2.5}, {.6, -.3, 2.5}},
                                         floor_point(0, 0)),
                1e-10);
}

TEST(DiffuseSource, a_frame_lights_as_its_outline_less_its_hole) {
    PolygonOpening frame = panel(2, 2);
    frame.region.holes.push_back({{-0.5, -0.5, 0}, {0.5, -0.5, 0}, {0.5, 0.5, 0}, {-0.5, 0.5, 0}});
    const double whole = lux(luminaire_at({0, 0, 2}, panel(2, 2), Luminance{1000}), floor_point(0.3, 0));
    const double hole = lux(luminaire_at({0, 0, 2}, panel(1, 1), Luminance{1000}), floor_point(0.3, 0));
    const Luminaire framed = luminaire_at({0, 0, 2}, frame, Luminance{1000});
    EXPECT_NEAR(lux(framed, floor_point(0.3, 0)), whole - hole, 1e-10);
    const auto thread_at = [](double x) {
        return OccluderSet({sheet({{x, -0.001, 0.5}, {x + 0.002, -0.001, 0.5}, {x + 0.002, 0.001, 0.5}})});
    };
    const OccluderSet before_the_hole = thread_at(0.31), before_the_frame = thread_at(0.4);
    EXPECT_NEAR(lux(framed, floor_point(0.3, 0), &before_the_hole), whole - hole, 1e-10);
    EXPECT_LT(lux(framed, floor_point(0.3, 0), &before_the_frame), whole - hole - 1e-4);
    EXPECT_NEAR(lux(framed, floor_point(0.3, 0), &before_the_frame), whole - hole, 0.02);  // 8 mm by 8 mm of it
}

TEST(DiffuseSource, an_opaque_luminaire_does_not_hide_its_own_light) {
    const Luminaire light = luminaire_at({0, 0, 2.5}, panel(1.2, 0.6), Luminance{5000});
    const Polygon opening = {{-.6, -.3, 2.5}, {-.6, .3, 2.5}, {.6, .3, 2.5}, {.6, -.3, 2.5}};
    for (const std::uint32_t owner : {light.id.value, 99U}) {  // its own body, or another's in its place
        const OccluderSet set({sheet(opening, owner)});
        EXPECT_EQ(lux(light, floor_point(1, 0.5), &set), lux(light, floor_point(1, 0.5)));
    }
    const Luminaire above = luminaire_at({0, 0, 3}, panel(0.1, 0.1), Luminance{5000});
    const OccluderSet set({sheet(opening, light.id.value + 1)});
    EXPECT_EQ(lux(above, floor_point(0, 0), &set), 0.0);
}

PolyhedronOpening glowing_box(const Vec3& size) {
    PolyhedronOpening box;
    for (int k = 0; k < 8; ++k) {
        box.vertices.emplace_back(k & 1 ? size.x : 0.0, k & 2 ? size.y : 0.0, k & 4 ? size.z : 0.0);
    }
    box.faces = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
    return box;
}

TEST(DiffuseSource, faces_of_a_box_shine_by_their_weights) {
    PolyhedronOpening box = glowing_box({1, 1, 0.5});
    const Luminaire even = luminaire_at({-0.5, -0.5, 2}, box, Luminance{1000});
    EXPECT_NEAR(Emitter(bare, even).flux().value, pi * 1000 * 4, 1e-9);
    EXPECT_NEAR(lux(even, floor_point(0, 0)),
                lux(luminaire_at({0, 0, 2}, panel(1, 1), Luminance{1000}), floor_point(0, 0)),
                1e-10);  // straight below only the lower face is seen
    box.relative_luminance = {0.5, 0, 0, 0, 0, 0};
    const Luminaire weighted = luminaire_at({-0.5, -0.5, 2}, box, Luminance{1000});
    EXPECT_NEAR(lux(weighted, floor_point(3, 0)),
                0.5 * lux(luminaire_at({0, 0, 2}, panel(1, 1), Luminance{1000}), floor_point(3, 0)), 1e-10);
    EXPECT_NEAR(Emitter(bare, weighted).flux().value, pi * 500, 1e-9);
}

TEST(DiffuseSource, faces_of_an_angle_hide_each_other) {
    // An L-shaped prism; from beyond its long leg the inner face of the short one is hidden in part.
    PolyhedronOpening angle;
    const std::vector<Vec2> plan = {{0, 0}, {2, 0}, {2, 0.5}, {0.5, 0.5}, {0.5, 2}, {0, 2}};
    for (const double z : {0.0, 1.0}) {
        for (const Vec2& corner : plan) angle.vertices.emplace_back(corner, z);
    }
    angle.faces = {{5, 4, 3, 2, 1, 0}, {6, 7, 8, 9, 10, 11}};
    for (int k = 0; k < 6; ++k) angle.faces.push_back({k, (k + 1) % 6, 6 + (k + 1) % 6, 6 + k});
    angle.relative_luminance = {0, 0, 0, 0, 0, 1, 0, 0};  // only the inner face at x = 0.5 shines, to +x
    const Luminaire light = luminaire_at({0, 0, 0}, angle, Luminance{1000});
    const Receiver below{{1.5, -1, 0.5}, {0, 1, 0}, {}};  // the other leg stands between
    const Receiver above{{1.5, 1.5, 0.5}, {-1, 0, 0}, {}};
    EXPECT_EQ(lux(light, below), 0.0);
    const Luminaire alone = luminaire_at(
        {0, 0, 0}, PolygonOpening{{{{.5, .5, 0}, {.5, 2, 0}, {.5, 2, 1}, {.5, .5, 1}}, {}}}, Luminance{1000});
    EXPECT_GT(lux(alone, below), 1.0);
    EXPECT_NEAR(lux(light, above), lux(alone, above), 1e-10);
}

TEST(Emitter, all_light_that_leaves_arrives_on_a_closed_box) {
    std::vector<Luminaire> kinds = {
        luminaire_at({0.1, 0.2, 0.1}, PointOpening{}, LuminousFlux{1000}),
        luminaire_at({0, 0, 0}, LineOpening{{-0.5, 0, 0}, {0.4, 0.2, 0.3}}, LuminousFlux{1000}),
        luminaire_at({0.1, 0.1, 0.3}, panel(1, 0.5), LuminousFlux{1000}),
        luminaire_at({-0.3, 0, 0.2}, glowing_box({0.5, 0.4, 0.3}), LuminousFlux{1000})};
    kinds[2].tilt = 0.4;
    kinds.push_back(kinds[0]);
    kinds.back().distribution = CosinePower{3};
    std::vector<Polygon> patches;
    std::vector<ReceivingPolygon> receiving;
    const int n = 24;
    for (int axis = 0; axis < 3; ++axis) {
        for (int k = 0; k < 2 * n * n; ++k) {
            const double u = -1.5 + 3.0 / n * (k / 2 % n), v = -1.5 + 3.0 / n * (k / 2 / n), h = k % 2 ? 1.5 : -1.5;
            Polygon patch;
            for (const Vec2 c : {Vec2{0, 0}, Vec2{1, 0}, Vec2{1, 1}, Vec2{0, 1}}) {
                Vec3 corner;
                corner[axis] = h;
                corner[(axis + 1) % 3] = u + c.x * 3.0 / n;
                corner[(axis + 2) % 3] = v + c.y * 3.0 / n;
                patch.push_back(corner);
            }
            patches.push_back(patch);
        }
    }
    for (const Polygon& patch : patches) {
        Vec3 inward{0};
        for (int axis = 0; axis < 3; ++axis) {
            if (patch[0][axis] == patch[2][axis]) inward[axis] = patch[0][axis] > 0 ? -1 : 1;
        }
        receiving.push_back({patch, inward});
    }
    for (const Luminaire& luminaire : kinds) {
        const auto means = mean_direct_illuminance(Emitter(bare, luminaire), receiving, nullptr, {});
        double flux = 0;
        for (const double mean : *means) flux += mean * 9.0 / (n * n);
        EXPECT_NEAR(flux, 1000, 0.05);  // patches an eighth of a metre, a metre from the light
    }
}

}  // namespace
}  // namespace hanei
