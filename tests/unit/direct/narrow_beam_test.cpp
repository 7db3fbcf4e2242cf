/// Beams narrower than a patch: all of their flux falls within a few patches, wherever the nodes are.
#include "engine/direct/direct.h"
#include "tests/unit/direct/scenes.h"
#include "tests/unit/geometry/shapes.h"

#include <gtest/gtest.h>

namespace hanei {
namespace {

using testing::luminaire_at;

constexpr double width = 0.4;  // m, of a patch
constexpr int across = 11;

/// 11 x 11 patches about the origin, as a floor.
std::vector<Polygon> floor_patches() {
    std::vector<Polygon> patches;
    for (int k = 0; k < across * across; ++k) {
        const double x = width * (k % across - 0.5 * across), y = width * (k / across - 0.5 * across);
        patches.push_back(testing::facing_up(x, y, x + width, y + width, 0));
    }
    return patches;
}

double flux_on_floor(const Luminaire& luminaire, const OccluderSet* occluders) {
    const std::vector<Polygon> patches = floor_patches();
    std::vector<ReceivingPolygon> polygons;
    for (const Polygon& patch : patches) polygons.push_back({patch, {0, 0, 1}});
    const Emitter emitter(Scene{}, luminaire);
    const auto means = mean_direct_illuminance(emitter, polygons, occluders, {});
    double flux = 0.0;
    for (const double lux : *means) flux += width * width * lux;
    return flux;
}

Luminaire beam(double exponent, const Vec3& place) {
    Luminaire luminaire = luminaire_at(place, PointOpening{}, LuminousFlux{1000});
    luminaire.distribution = CosinePower{exponent};
    return luminaire;
}

TEST(NarrowBeam, keeps_its_flux_wherever_it_falls_between_the_nodes) {
    for (const double exponent : {300.0, 3e3, 2e4, 1e6, 1e8})
        for (const Vec3& place :
             {Vec3{0.0, 0.0, 2.5}, Vec3{0.2, 0.2, 2.5}, Vec3{0.13, -0.07, 2.5}, Vec3{0.2, 0.0, 0.4}})
            EXPECT_NEAR(flux_on_floor(beam(exponent, place), nullptr), 1000, 5) << exponent << " at " << place.x;
}

TEST(NarrowBeam, keeps_its_flux_where_it_falls_aslant) {
    Luminaire luminaire = beam(2e4, {-1.5, 0.1, 1.2});
    luminaire.tilt = 0.9;
    EXPECT_NEAR(flux_on_floor(luminaire, nullptr), 1000, 5);
    luminaire.tilt = -0.9;  // out past the floor's edge
    EXPECT_LT(flux_on_floor(luminaire, nullptr), 1000);
}

TEST(NarrowBeam, is_held_back_by_half_where_an_edge_cuts_it_through_the_middle) {
    const OccluderSet half({testing::sheet(testing::facing_up(0.13, -2, 3, 2, 1), 1)});
    EXPECT_NEAR(flux_on_floor(beam(2e4, {0.13, -0.07, 2.5}), &half), 500, 5);
}

}  // namespace
}  // namespace hanei
