/// The unobstructed kernels: nanoseconds an edge by the loop's size and place, and a call of the
/// others.
#include "engine/direct/line_source.h"
#include "engine/geometry/configuration_factor.h"
#include "tests/bench/row.h"
#include "tests/unit/geometry/shapes.h"

#include <cmath>
#include <numbers>
#include <vector>

namespace hanei::bench {

namespace {

using testing::Dice;

constexpr std::size_t variety = 256;  // so that no branch is learnt by heart

Polygon star(Dice& dice, int corners, const Vec3& middle, const Mat3& turn, double size) {
    Polygon polygon;
    for (int k = 0; k < corners; ++k) {
        const double angle = 2.0 * std::numbers::pi * k / corners, reach = size * dice.uniform(0.8, 1.0);
        polygon.push_back(middle + turn * (reach * Vec3{std::cos(angle), std::sin(angle), 0.0}));
    }
    return polygon;
}

/// Openings of about `size` metres 1 to 3 m away; the normal points at them, or across their middle.
void openings(benchmark::State& state, double size, bool across_horizon) {
    const auto corners = static_cast<int>(state.range(0));
    Dice dice(static_cast<std::uint64_t>(corners));
    std::vector<Polygon> polygons;
    std::vector<Receiver> receivers;
    while (polygons.size() < variety) {
        const Mat3 turn = dice.rotation();
        const Vec3 middle = dice.uniform(1.0, 3.0) * dice.direction();
        if (glm::dot(turn[2], middle) > -0.3) continue;
        const Vec3 aside = glm::normalize(glm::cross(middle, dice.direction()));
        polygons.push_back(star(dice, corners, middle, turn, 0.5 * size));
        receivers.push_back({Vec3{0}, across_horizon ? aside : glm::normalize(middle + aside), Vec3{0}});
    }
    std::size_t k = 0;
    for (auto _ : state) {
        benchmark::DoNotOptimize(configuration_factor(polygons[k], receivers[k]));
        k = (k + 1) % variety;
    }
    Row row;
    row.edges = corners;
    row.report(state);
}

void tube(benchmark::State& state) {
    Dice dice(5);
    std::vector<LineSource> tubes;
    std::vector<Receiver> receivers;
    for (std::size_t k = 0; k < variety; ++k) {
        tubes.push_back({dice.place(2.0), dice.place(2.0), 100.0});
        receivers.push_back({dice.place(2.0), dice.direction(), Vec3{0}});
    }
    std::size_t k = 0;
    for (auto _ : state) {
        benchmark::DoNotOptimize(tubes[k].unobstructed(receivers[k]));
        k = (k + 1) % variety;
    }
    Row{}.report(state);
}

void loops(benchmark::internal::Benchmark* each) {
    each->ArgName("edges");
    for (const int corners : {3, 4, 5, 6, 8, 12, 16, 32, 64}) each->Arg(corners);
}

BENCHMARK_CAPTURE(openings, , 1.5, false)->Name("near")->Apply(loops);
BENCHMARK_CAPTURE(openings, , 1.5, true)->Name("across_the_horizon")->Apply(loops);
BENCHMARK_CAPTURE(openings, , 0.03, false)->Name("far")->ArgName("edges")->Arg(4);
BENCHMARK_CAPTURE(openings, , 0.002, false)->Name("very_far")->ArgName("edges")->Arg(4);
BENCHMARK(tube);

}  // namespace

}  // namespace hanei::bench
