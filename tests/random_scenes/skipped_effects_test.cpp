/// What is skipped stays within its bound, in rooms at random.
///
/// HANEI_SKIP_ROOMS   how many (HANEI_SKIP_FIRST: the first seed); the worst are told on stdout.
#include "engine/scene/colour.h"
#include "engine/study/study.h"
#include "tests/random_scene.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <gtest/gtest.h>

namespace hanei {
namespace {

std::uint64_t figure_of(const char* name, std::uint64_t usual) {
    const char* const wished = std::getenv(name);
    return wished != nullptr ? std::strtoull(wished, nullptr, 10) : usual;
}

ObjectId random_material(Scene& scene, test::Dice& dice, double most) {
    Material material;
    material.id = scene.new_id();
    material.reflectance = dice.in(0.0, most);
    if (dice.chance(0.3)) {
        const Vec3 screen{dice.in(0.1, 1.0), dice.in(0.1, 1.0), dice.in(0.1, 1.0)};
        const Vec3 tint = tint_from_srgb(screen, material.reflectance);
        material.tint = tint;
    }
    scene.materials.push_back(material);
    return material.id;
}

/// A room with a few boxes, from specks to wardrobes, some hanging in the air or standing on each other.
Scene random_room(test::Dice& dice) {
    Scene scene;
    const Vec3 size{dice.in(2.0, 8.0), dice.in(2.0, 8.0), dice.in(2.2, 4.0)};
    const double most = dice.pick({0.05, 0.5, 0.9});
    Room room;
    room.id = scene.new_id();
    room.plan = {{0.0, 0.0}, {size.x, 0.0}, {size.x, size.y}, {0.0, size.y}};
    room.height = size.z;
    room.floor_material = random_material(scene, dice, most);
    room.ceiling_material = random_material(scene, dice, most);
    for (int wall = 0; wall < 4; ++wall) room.wall_materials.push_back(random_material(scene, dice, most));
    scene.room = std::move(room);
    for (int count = 1 + dice.below(5); count > 0; --count) {
        Furniture box;
        box.id = scene.new_id();
        const Vec3 sides{dice.logarithmic(0.05, 1.2), dice.logarithmic(0.05, 1.2), dice.logarithmic(0.05, 1.8)};
        box.position = {dice.in(0.9, size.x - 0.9), dice.in(0.9, size.y - 0.9),
                        dice.chance(0.7) ? 0.0 : dice.in(0.0, size.z - 2.0)};
        box.rotation = dice.in(0.0, 3.0);
        Part part;
        part.shape = BoxShape{sides};
        part.material = random_material(scene, dice, dice.pick({0.1, 0.9}));
        box.parts.push_back(part);
        scene.furniture.push_back(std::move(box));
    }
    for (int count = 1 + dice.below(3); count > 0; --count) {
        Luminaire lamp;
        lamp.id = scene.new_id();
        lamp.position = {dice.in(0.7, size.x - 0.7), dice.in(0.7, size.y - 0.7), size.z - dice.in(0.02, 0.15)};
        lamp.output = LuminousFlux{dice.in(100.0, 4000.0)};
        const int kind = dice.below(3);
        if (kind == 0) {
            const double x = dice.in(0.05, 0.6), y = dice.in(0.05, 0.6);
            lamp.opening = PolygonOpening{{{{-x, -y, 0}, {-x, y, 0}, {x, y, 0}, {x, -y, 0}}, {}}};
        } else if (kind == 1) {
            lamp.opening = LineOpening{{-0.6, 0.0, 0.0}, {0.6, 0.0, 0.0}};
        } else {
            lamp.distribution = CosinePower{dice.in(1.0, 8.0)};
        }
        if (dice.chance(0.3)) lamp.colour_temperature = dice.in(2500.0, 6500.0);
        scene.luminaires.push_back(std::move(lamp));
    }
    for (int count = 0; count < 12; ++count) {
        CalculationPoint point;
        point.id = scene.new_id();
        point.position = dice.in_box({0.05, 0.05, 0.0}, {size.x - 0.05, size.y - 0.05, size.z - 0.2});
        if (dice.chance(0.5)) point.position.z = dice.chance(0.5) ? 0.0 : 0.75;
        point.normal = point.position.z == 0.0 || dice.chance(0.7) ? Vec3{0.0, 0.0, 1.0} : dice.direction();
        scene.points.push_back(point);
    }
    return scene;
}

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
        const std::uint64_t first = figure_of("HANEI_SKIP_FIRST", 1), count = figure_of("HANEI_SKIP_ROOMS", 12);
        for (std::uint64_t seed = first; seed < first + count; ++seed) {
            test::Dice dice(seed);
            const auto scene = std::make_shared<const Scene>(random_room(dice));
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
