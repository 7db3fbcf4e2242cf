/// Means over patches against the light at very many places of them, and against the flux sent.
#include "engine/direct/light_on_luminaires.h"
#include "engine/mesh/mesh.h"
#include "tests/box_room.h"
#include "tests/unit/direct/scenes.h"
#include "tests/unit/geometry/shapes.h"

#include <algorithm>
#include <gtest/gtest.h>

namespace hanei {
namespace {

using testing::box_body;
using testing::Dice;
using testing::luminaire_at;
using testing::pi;
using testing::table;

Scene with_batwing() {
    Scene scene;
    scene.photometries = {
        table([](double gamma) { return gamma < pi / 2 ? 200 + 800 * std::pow(std::sin(2 * gamma), 2) : 0; }, 5)};
    return scene;
}

std::vector<Luminaire> every_kind() {
    std::vector<Luminaire> kinds;
    kinds.push_back(luminaire_at({0.2, 0.1, 2.6}, testing::panel(1.2, 0.6), LuminousFlux{3000}));
    kinds.push_back(luminaire_at({0.2, 0.1, 2.6}, PointOpening{}, LuminousFlux{3000}));
    kinds.push_back(luminaire_at({0.2, 0.1, 2.6}, LineOpening{{-0.6, 0, 0}, {0.6, 0, 0}}, LuminousFlux{3000}));
    kinds.push_back(kinds.front());
    kinds.back().distribution = Measured{ObjectId{3}};
    return kinds;
}

OccluderSet some_furniture() {
    Dice dice(4);
    std::vector<ConvexBody> bodies;
    for (int k = 0; k < 14; ++k) {
        const Vec3 low{dice.uniform(-2, 2), dice.uniform(-2, 2), dice.uniform(0.1, 1.2)};
        bodies.push_back(box_body(low, low + Vec3{dice.uniform(0.05, 0.8), dice.uniform(0.05, 0.8), 0.3}));
    }
    return OccluderSet(std::move(bodies));
}

std::vector<Polygon> floor_patches() {
    std::vector<Polygon> patches;
    for (int k = 0; k < 49; ++k)
        patches.push_back(testing::facing_up(-2.1 + 0.6 * (k % 7), -2.1 + 0.6 * (k / 7), -1.5 + 0.6 * (k % 7),
                                             -1.5 + 0.6 * (k / 7), 0));
    return patches;
}

std::vector<ReceivingPolygon> facing_up(const std::vector<Polygon>& patches) {
    std::vector<ReceivingPolygon> polygons;
    for (const Polygon& patch : patches) polygons.push_back({patch, {0, 0, 1}});
    return polygons;
}

double summed(const Emitter& emitter, const Polygon& patch, const OccluderSet& occluders, int n) {
    double sum = 0;
    for (int k = 0; k < n * n; ++k) {
        // Out of step with the furniture's edges.
        const double u = std::fmod(0.5 + 0.7548776662466927 * k, 1.0), v = std::fmod(0.5 + 0.5698402909980532 * k, 1.0);
        const Vec3 at = patch[0] + u * (patch[1] - patch[0]) + v * (patch[3] - patch[0]);
        sum += emitter.illuminance({at, {0, 0, 1}, {}}, &occluders).value;
    }
    return sum / (n * n);
}

TEST(MeanAccuracy, the_claim_holds_however_loosely_it_is_asked) {
    const Scene scene = with_batwing();
    const OccluderSet occluders = some_furniture();
    const std::vector<Polygon> patches = floor_patches();
    int cases = 0, within = 0, allowed = 0;
    for (const Luminaire& luminaire : every_kind()) {
        const Emitter emitter(scene, luminaire);
        std::vector<double> expected, own_error;
        for (const Polygon& patch : patches) {
            expected.push_back(summed(emitter, patch, occluders, 40));
            own_error.push_back(std::abs(expected.back() - summed(emitter, patch, occluders, 28)) +
                                1e-3 * expected.back());
        }
        for (const double share : {0.03, 0.01, 3e-3}) {
            const Accuracy accuracy{share, share * 20};
            const auto got = mean_direct_estimates(emitter, facing_up(patches), &occluders, accuracy, {});
            for (std::size_t k = 0; k < patches.size(); ++k) {
                const double claim = (*got)[patches.size() + k];
                ++cases;
                if (std::abs((*got)[k] - expected[k]) <= claim + own_error[k]) ++within;
                if (claim <= 1.001 * accuracy.allowed((*got)[k])) ++allowed;
            }
        }
    }
    EXPECT_GE(within, 0.96 * cases);   // furniture that all but fills the sight lines: nodes see slits of it
    EXPECT_GE(allowed, 0.98 * cases);  // a few end with their cuts used up
}

TEST(MeanAccuracy, closer_looks_come_nearer) {
    const Scene scene = with_batwing();
    const OccluderSet occluders = some_furniture();
    const std::vector<Polygon> patches = floor_patches();
    for (const Luminaire& luminaire : every_kind()) {
        const Emitter emitter(scene, luminaire);
        const auto finest = *mean_direct_illuminance(emitter, facing_up(patches), &occluders, {});
        const auto off = [&](double share) {
            const auto got = *mean_direct_estimates(emitter, facing_up(patches), &occluders, {share, share * 20}, {});
            double worst = 0;
            for (std::size_t k = 0; k < patches.size(); ++k) worst = std::max(worst, std::abs(got[k] - finest[k]));
            return worst / *std::ranges::max_element(finest);
        };
        EXPECT_LE(off(3e-3), 6e-3);
        EXPECT_LE(off(0.03), 6e-2);
    }
}

TEST(MeanAccuracy, all_light_arrives_in_a_closed_furnished_room) {
    Scene scene = test::box_room({5, 4, 2.8}, 0.5);
    for (const Vec3& at : {Vec3{1.2, 1, 0}, Vec3{3.5, 1.2, 0}, Vec3{2.4, 2.9, 0}})
        scene.furniture.push_back(test::box(scene, at, {0.9, 0.7, 0.75}));
    scene.photometries = with_batwing().photometries;
    const auto mesh = make_mesh(scene, 0.6);
    const OccluderSet occluders = occluders_of(scene);
    std::vector<ReceivingPolygon> polygons;
    for (const Patch& patch : mesh->patches) polygons.push_back({patch.outline, mesh->faces[patch.face].face.normal});
    for (Luminaire luminaire : every_kind()) {
        luminaire.position += Vec3{2.3, 1.9, 0};
        const Emitter emitter(scene, luminaire);
        for (const double share : {0.0, 3e-3, 0.01}) {
            const auto means = *mean_direct_estimates(emitter, polygons, &occluders, {share, share * 20}, {});
            double flux = 0;
            for (std::size_t k = 0; k < polygons.size(); ++k) flux += means[k] * mesh->patches[k].area;
            EXPECT_NEAR(flux / emitter.flux().value, 1, std::max(1e-3, 0.5 * share));
        }
    }
}

TEST(MeanAccuracy, what_a_lamp_in_the_way_takes_is_not_lost) {
    Scene scene = test::box_room({5, 4, 2.8}, 0.5);
    const double h = 0.15;
    PolyhedronOpening cube;
    for (int k = 0; k < 8; ++k) cube.vertices.emplace_back(k & 1 ? h : -h, k & 2 ? h : -h, k & 4 ? h : -h);
    cube.faces = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
    scene.luminaires.push_back(test::panel(scene, {2.5, 2, 2.7}, {1.2, 0.6}, 3000));
    scene.luminaires.push_back(luminaire_at({2.6, 2.1, 1.7}, cube, LuminousFlux{500}));
    scene.luminaires.back().id = scene.new_id();
    scene.luminaires.back().opaque = true;
    const auto mesh = make_mesh(scene, 0.6);
    const OccluderSet occluders = occluders_of(scene);
    std::vector<ReceivingPolygon> polygons;
    for (const Patch& patch : mesh->patches) polygons.push_back({patch.outline, mesh->faces[patch.face].face.normal});
    const Emitter panel(scene, scene.luminaires[0]);
    const auto means = *mean_direct_estimates(panel, polygons, &occluders, {1e-3, 0.01}, {});
    double on_walls = 0;
    for (std::size_t k = 0; k < polygons.size(); ++k) on_walls += means[k] * mesh->patches[k].area;
    const Estimate on_lamp = *flux_on_luminaires(panel, scene, occluders, {1e-3, 0.01}, {});
    EXPECT_GT(on_lamp.value, 50.0);
    EXPECT_NEAR((on_walls + on_lamp.value) / panel.flux().value, 1, 1e-3);
}

TEST(MeanAccuracy, the_hard_shadow_of_a_point_has_an_exact_border) {
    const Emitter emitter(Scene{}, luminaire_at({0, 0, 2}, PointOpening{}, LuminousFlux{1000}));
    // A sheet half way up whose edge lies over x = 0.15: its shadow begins at x = 0.3.
    const Polygon outline = testing::facing_up(0.15, -2, 3, 2, 1);
    const OccluderSet sheet({testing::sheet(outline, 1)});
    const Polygon patch = testing::facing_up(0.05, -0.2, 0.55, 0.2, 0),
                  lit = testing::facing_up(0.05, -0.2, 0.3, 0.2, 0);
    const ReceivingPolygon polygons[] = {{patch, {0, 0, 1}}, {lit, {0, 0, 1}}};
    const auto means = *mean_direct_illuminance(emitter, polygons, &sheet, {});
    EXPECT_NEAR(means[0] / (0.5 * means[1]), 1, 1e-5);
}

}  // namespace
}  // namespace hanei
