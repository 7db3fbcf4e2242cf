/// How often the truth lies within the error bar, in rooms at random.
///
/// HANEI_BAR_ROOMS   how many (HANEI_BAR_FIRST: the first seed); the figures are told on stdout.
#include "engine/study/study.h"
#include "tests/random_scenes/random_room.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <gtest/gtest.h>

namespace hanei {
namespace {

struct Coverage {
    int compared = 0;
    int covered = 0;  ///< off by no more than the bar
    int broken = 0;   ///< off by more than the bar and what the reference itself leaves open
    double worst = 0.0;
    std::uint64_t worst_room = 0;
    std::vector<double> bar_over_error;  ///< where nothing is skipped and the reference knows the error

    void see(const PointValue& value, const PointValue& reference, std::uint64_t room) {
        const double off = std::abs(value.total().value - reference.total().value);
        const double bar = value.error.total();
        const double open = reference.error.total();
        ++compared;
        if (off <= bar) ++covered;
        if (off > bar + open) ++broken;
        if (off > open && value.error.skipped == 0.0) bar_over_error.push_back(bar / off);
        if (off > worst * (bar + open)) {
            worst = off / (bar + open);
            worst_room = room;
        }
    }

    double share() const { return static_cast<double>(covered) / std::max(1, compared); }
    double median() {
        if (bar_over_error.empty()) return 0.0;
        const auto middle = bar_over_error.begin() + static_cast<std::ptrdiff_t>(bar_over_error.size() / 2);
        std::nth_element(bar_over_error.begin(), middle, bar_over_error.end());
        return *middle;
    }
    void tell(const char* what) {
        std::printf(
            "%s: %d values, %.2f %% within their bar, %d surely not (greatest error %.2f of both bars, room "
            "%llu), the bar is %.2f of the error in the median\n",
            what, compared, 100.0 * share(), broken, worst, (unsigned long long)worst_room, median());
    }
};

SolutionSnapshot solve(const SceneSnapshot& scene, const Settings& settings) {
    return Study().run(scene, settings, {}, {});
}

/// Now and then with something skipped.
Settings settings_of(Method method, double max_patch, std::uint64_t seed) {
    Settings settings;
    settings.method = method;
    settings.max_patch = max_patch;
    settings.tolerance_lux = seed % 4 == 0 ? 20.0 : 0.0;
    return settings;
}

TEST(ErrorBars, hold_the_value_of_a_much_finer_solution) {
    Coverage patch, linear;
    const std::uint64_t first = test::number_of("HANEI_BAR_FIRST", 1), count = test::number_of("HANEI_BAR_ROOMS", 5);
    for (std::uint64_t seed = first; seed < first + count; ++seed) {
        test::Dice dice(seed);
        const auto scene = std::make_shared<const Scene>(test::random_room(dice));
        Settings fine;
        fine.method = Method::linear;
        fine.accuracy = 1e-5;
        const auto reference = solve(scene, fine);
        const auto by_patch = solve(scene, settings_of(Method::patch, 0.5, seed));
        const auto by_linear = solve(scene, settings_of(Method::linear, 1.0, seed));
        for (std::size_t k = 0; k < reference->points.size(); ++k) {
            if (reference->points[k].value.inside_solid) continue;
            patch.see(by_patch->points[k].value, reference->points[k].value, seed);
            linear.see(by_linear->points[k].value, reference->points[k].value, seed);
        }
    }
    patch.tell("patch");
    linear.tell("linear");
    EXPECT_GE(patch.share(), 0.95);
    EXPECT_GE(linear.share(), 0.95);
    EXPECT_GT(patch.compared, 0);
}

}  // namespace
}  // namespace hanei
