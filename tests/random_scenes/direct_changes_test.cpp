/// What shadows, soft edges and the size of openings change stays within its bound, in scenes at random.
///
/// HANEI_CHANGE_SCENES   how many (HANEI_CHANGE_FIRST: the first seed); the worst are told on stdout.
#include "engine/plan/direct_changes.h"

#include "engine/direct/direct.h"
#include "engine/mesh/mesh.h"
#include "engine/plan/measured_openings.h"
#include "engine/plan/places.h"
#include "engine/scene/dimmers.h"
#include "engine/scene/placement.h"
#include "tests/random_scene.h"
#include "tests/random_scenes/random_room.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <gtest/gtest.h>
#include <numeric>

namespace hanei {
namespace {

struct Worst {
    int compared = 0, changed = 0, violations = 0;
    double ratio = 0.0;
    std::uint64_t seed = 0;

    void see(double change, double bound, double unknown, std::uint64_t of) {
        ++compared;
        constexpr double rounding = 1e-6;  // lx, of light that grazes
        if (change <= unknown + rounding) return;
        ++changed;
        if (change > bound + unknown) {
            ++violations;
            std::printf("scene %llu: changed by %g lx, bound %g lx, unknown %g lx\n", (unsigned long long)of, change,
                        bound, unknown);
        }
        if (bound > 0.0 && change / bound > ratio) {
            ratio = change / bound;
            seed = of;
        }
    }
    void tell(const char* what) const {
        std::printf("%s: %d values, %d changed, %d beyond the bound, greatest share of it %.3f (scene %llu)\n", what,
                    compared, changed, violations, ratio, (unsigned long long)seed);
    }
};

/// lx, and by how much it may be off.
struct Light {
    double lux = 0.0, unknown = 0.0;
    void add(double output, const Estimate& estimate) {
        lux += output * estimate.value;
        unknown += output * estimate.error + 1e-9 * output * estimate.value;
    }
};

TEST(DirectChanges, hold_what_shadows_and_openings_change) {
    Worst shadows, penumbra, openings;
    const std::uint64_t first = test::number_of("HANEI_CHANGE_FIRST", 1),
                        count = test::number_of("HANEI_CHANGE_SCENES", 60);
    for (std::uint64_t seed = first; seed < first + count; ++seed) {
        const Scene scene = test::random_scene(seed);
        const std::vector<Receiver> points = few_calculation_points(scene);
        const DirectChanges changes = direct_changes(scene, points);
        ASSERT_EQ(changes.shadows.size(), points.size());
        const OccluderSet occluders = occluders_of(scene);
        for (std::size_t k = 0; k < points.size(); ++k) {
            const Receiver point{points[k].position, glm::normalize(points[k].normal), Vec3{0.0}};
            if (occluders.containing(point.position) >= 0) continue;
            Light exact, open, hard, from_middle;
            for (const Luminaire& luminaire : scene.luminaires) {
                const double output = dimming_of(scene, luminaire) * scene.maintenance_factor;
                if (!(output > 0.0)) continue;
                const Emitter emitter(scene, luminaire);
                const Estimate all = emitter.estimate(point, nullptr), seen = emitter.estimate(point, &occluders);
                exact.add(output, seen);
                open.add(output, all);
                const std::span<const Vec3> extent = emitter.extent();
                const Vec3 centre = std::accumulate(extent.begin(), extent.end(), Vec3{0.0}) / double(extent.size());
                std::vector<BodyIndex> between;
                occluders.between(point.position, std::span(&centre, 1), between, luminaire.id.value);
                const bool hidden = occluders.blocks(point.position, centre, between);
                const bool is_point = extent.size() == 1;
                hard.add(output, is_point ? seen : hidden ? Estimate{} : all);
                const auto measured = measured_opening_of(scene, luminaire);
                Luminaire middle = luminaire;
                if (measured) {
                    middle.opening = PointOpening{};
                    middle.position = placement(luminaire).point(measured->form.centre);
                }
                from_middle.add(output, measured ? Emitter(scene, middle).estimate(point, &occluders) : seen);
            }
            shadows.see(std::abs(open.lux - exact.lux), changes.shadows[k], open.unknown + exact.unknown, seed);
            penumbra.see(std::abs(hard.lux - exact.lux), changes.penumbra[k], hard.unknown + exact.unknown, seed);
            openings.see(std::abs(from_middle.lux - exact.lux), changes.openings[k],
                         from_middle.unknown + exact.unknown, seed);
        }
    }
    shadows.tell("shadows");
    penumbra.tell("penumbra");
    openings.tell("openings");
    for (const Worst& worst : {shadows, penumbra, openings}) {
        EXPECT_EQ(worst.violations, 0);
        EXPECT_GT(worst.changed, 0);
    }
}

}  // namespace
}  // namespace hanei
