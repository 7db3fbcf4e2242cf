/// What is skipped stays within its bound, in rooms at random.
///
/// HANEI_SKIP_ROOMS   how many (HANEI_SKIP_FIRST: the first seed); the worst are told on stdout.
#include "engine/study/study.h"
#include "tests/random_scenes/random_room.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <gtest/gtest.h>

namespace hanei {
namespace {

struct Worst {
    double ratio = 0.0;
    std::uint64_t seed = 0;
    int violations = 0, compared = 0;
    double sum = 0.0;

    void see(double difference, double bound, double unknown, std::uint64_t of) {
        ++compared;
        if (difference > bound + unknown) {
            ++violations;
            std::printf("room %llu: off by %g lx, bound %g lx, unknown %g lx\n", (unsigned long long)of, difference,
                        bound, unknown);
        }
        if (bound <= unknown) return;  // too small to be told from rounding
        sum += difference / bound;
        if (difference / bound <= ratio) return;
        ratio = difference / bound;
        seed = of;
    }
};

class SkippedEffects : public testing::Test {
protected:
    static SolutionSnapshot solve(const SceneSnapshot& scene, const Settings& settings) {
        return Study().run(scene, settings, {.display = false}, {});
    }

    /// Compares every room without the effect to the same room with it.
    static Worst worst_without(EffectChoice Settings::*effect) {
        Worst worst;
        const std::uint64_t first = test::number_of("HANEI_SKIP_FIRST", 1),
                            count = test::number_of("HANEI_SKIP_ROOMS", 12);
        for (std::uint64_t seed = first; seed < first + count; ++seed) {
            test::Dice dice(seed);
            const auto scene = std::make_shared<const Scene>(test::random_room(dice));
            Settings settings;
            settings.max_patch = 0.6;
            settings.accuracy = 1e-6;
            for (const EffectOption& option : effect_options) settings.*option.member = EffectChoice::always;
            const auto with = solve(scene, settings);
            settings.*effect = EffectChoice::never;
            const auto without = solve(scene, settings);
            for (std::size_t k = 0; k < with->points.size(); ++k) {
                const PointValue &a = with->points[k].value, &b = without->points[k].value;
                if (a.inside_solid) continue;
                // Patches know either value no better than their own errors say.
                const double unknown = a.error.iteration + b.error.iteration + 1e-6 * a.total().value +
                                       (b.error.skipped < 0.01 * a.total().value ? a.error.mesh + b.error.mesh : 0.0);
                worst.see(std::abs(a.total().value - b.total().value), b.error.skipped, unknown, seed);
            }
        }
        return worst;
    }

    static void tell(const char* what, const Worst& worst) {
        std::printf("%s: %d values, %d beyond the bound, greatest share of it %.3f (room %llu), mean share %.4f\n",
                    what, worst.compared, worst.violations, worst.ratio, (unsigned long long)worst.seed,
                    worst.sum / std::max(1, worst.compared));
    }
};

TEST_F(SkippedEffects, interreflection_adds_no_more_than_its_bound) {
    const Worst worst = worst_without(&Settings::interreflection);
    tell("interreflection", worst);
    EXPECT_EQ(worst.violations, 0);
    EXPECT_GT(worst.ratio, 0.01);
}

TEST_F(SkippedEffects, furniture_reflects_no_more_than_its_bound) {
    const Worst worst = worst_without(&Settings::furniture);
    tell("furniture", worst);
    EXPECT_EQ(worst.violations, 0);
    EXPECT_GT(worst.ratio, 0.01);
}

TEST_F(SkippedEffects, colour_changes_lux_by_no_more_than_its_bound) {
    const Worst worst = worst_without(&Settings::colour);
    tell("colour", worst);
    EXPECT_EQ(worst.violations, 0);
}

}  // namespace
}  // namespace hanei
