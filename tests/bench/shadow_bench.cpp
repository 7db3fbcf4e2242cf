/// Exact light past many bodies, and the same by shadow rays: microseconds a receiver and luminaire,
/// and how wrong the rays are in the same time.
#include "tests/bench/row.h"
#include "tests/bench/settings.h"
#include "tests/bench/shadow_rays.h"

#include <algorithm>
#include <cmath>
#include <ctime>
#include <map>

namespace hanei::bench {

namespace {

using Find = const Setting& (*)(int);

double exact(const Setting& setting, std::size_t pair) {
    return setting.emitter(pair).illuminance(setting.receiver(pair), &setting.occluders).value;
}

double sampled(const Setting& setting, const ShadowRays& rays, std::size_t pair) {
    const double share = rays.visible_share(setting.receiver(pair), setting.panels[pair % 2]);
    return share * setting.lights[pair].unobstructed;
}

/// Seconds of the processor a pair, the best of three rounds over all pairs: waiting for a busy machine
/// is not counted.
template <class Answer>
double seconds_a_pair(const Setting& setting, Answer&& answer) {
    double best = 0.0;
    for (int round = 0; round < 3; ++round) {
        const std::clock_t start = std::clock();
        for (std::size_t pair = 0; pair < setting.pairs(); ++pair) benchmark::DoNotOptimize(answer(pair));
        const double seconds = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
        best = round == 0 ? seconds : std::min(best, seconds);
    }
    return best / static_cast<double>(setting.pairs());
}

Row shares(const Setting& setting) {
    Row row;
    row.umbra = setting.umbra;
    row.penumbra = setting.penumbra;
    row.lit = setting.lit;
    return row;
}

void exact_answer(benchmark::State& state, Find find) {
    const Setting& setting = find(static_cast<int>(state.range(0)));
    std::size_t pair = 0;
    for (auto _ : state) {
        benchmark::DoNotOptimize(exact(setting, pair));
        if (++pair == setting.pairs()) pair = 0;
    }
    Row row = shares(setting);
    row.time_over_exact = 1.0;
    row.report(state);
}

/// All receivers of a panel at once, side by side as on a calculation grid: bodies are found once a tile.
void exact_grid(benchmark::State& state, Find find) {
    const Setting& setting = find(static_cast<int>(state.range(0)));
    constexpr int side = 64;
    std::vector<Receiver> receivers;
    for (int tile = 0; tile < side; ++tile) {
        for (int k = 0; k < side; ++k) {
            const double x = (8 * (tile % 8) + k % 8 + 0.5) / side, y = (8 * (tile / 8) + k / 8 + 0.5) / side;
            receivers.push_back({{6.0 * x, 4.0 * y, 0.75}, {0, 0, 1}, Vec3{0}});
        }
    }
    const auto count = static_cast<benchmark::IterationCount>(receivers.size());
    while (state.KeepRunningBatch(count)) {
        benchmark::DoNotOptimize(direct_illuminance(setting.emitters[0], receivers, &setting.occluders, {}));
    }
    Row{}.report(state);
}

void report_errors(benchmark::State& state, const Setting& setting, const ShadowRays& rays, int samples) {
    Row row = shares(setting);
    row.samples = samples;
    double squares = 0.0;
    row.error_max = 0.0;
    for (std::size_t pair = 0; pair < setting.pairs(); ++pair) {
        const double error = std::abs(sampled(setting, rays, pair) - setting.lights[pair].arriving) / setting.brightest;
        squares += error * error;
        row.error_max = std::max(row.error_max, error);
    }
    row.error_rms = std::sqrt(squares / static_cast<double>(setting.pairs()));
    const double by_rays = seconds_a_pair(setting, [&](std::size_t pair) { return sampled(setting, rays, pair); });
    row.time_over_exact = by_rays / seconds_a_pair(setting, [&](std::size_t pair) { return exact(setting, pair); });
    row.report(state);
}

ShadowRays& rays_among(const Setting& setting) {
    static std::map<const Setting*, ShadowRays> made;
    return made.try_emplace(&setting, setting.occluders.bodies()).first->second;
}

void rays_answer(benchmark::State& state, const Setting& setting, int samples) {
    ShadowRays& rays = rays_among(setting);
    rays.set_samples(samples);
    std::size_t pair = 0;
    for (auto _ : state) {
        benchmark::DoNotOptimize(sampled(setting, rays, pair));
        if (++pair == setting.pairs()) pair = 0;
    }
    report_errors(state, setting, rays, samples);
}

void shadow_rays(benchmark::State& state, Find find) {
    rays_answer(state, find(static_cast<int>(state.range(0))), static_cast<int>(state.range(1)));
}

/// As many rays as the exact answer's time allows, 16 at least.
void rays_in_the_exact_time(benchmark::State& state, Find find) {
    const Setting& setting = find(static_cast<int>(state.range(0)));
    ShadowRays& rays = rays_among(setting);
    const double allowed = seconds_a_pair(setting, [&](std::size_t pair) { return exact(setting, pair); });
    int samples = 16;
    for (int more = 32; more <= 8192; more *= 2) {
        rays.set_samples(more);
        const double taken = seconds_a_pair(setting, [&](std::size_t pair) { return sampled(setting, rays, pair); });
        samples = std::max(16, 16 * static_cast<int>(more * allowed / taken / 16.0 + 0.5));
        if (samples <= more) break;
    }
    rays_answer(state, setting, samples);
}

using Arguments = benchmark::internal::Benchmark;

void boxes(Arguments* each) {
    each->ArgName("boxes")->Unit(benchmark::kMicrosecond);
    for (const int count : {10, 40, 150, 600, 5000, 100'000}) each->Arg(count);
}
void sticks(Arguments* each) {
    each->ArgName("sticks")->Unit(benchmark::kMicrosecond);
    for (const int count : {20, 100, 300, 1000}) each->Arg(count);
}
void boxes_and_rays(Arguments* each) {
    each->ArgNames({"boxes", "samples"})->Unit(benchmark::kMicrosecond);
    for (const int count : {10, 40, 150, 600, 5000, 100'000}) each->Args({count, 64})->Args({count, 1024});
    each->Args({40, 16'384});  // the rays draw near to the exact answer, not to another
}
void sticks_and_rays(Arguments* each) {
    each->ArgNames({"sticks", "samples"})->Unit(benchmark::kMicrosecond);
    for (const int count : {20, 100, 300, 1000}) each->Args({count, 64})->Args({count, 1024});
}

BENCHMARK_CAPTURE(exact_answer, , among_boxes)->Name("exact")->Apply(boxes);
BENCHMARK_CAPTURE(exact_answer, , among_sticks)->Name("exact")->Apply(sticks);
BENCHMARK_CAPTURE(exact_grid, , among_boxes)->Name("exact_grid")->Apply(boxes);
BENCHMARK_CAPTURE(exact_grid, , among_sticks)->Name("exact_grid")->Apply(sticks);
BENCHMARK_CAPTURE(shadow_rays, , among_boxes)->Name("rays")->Apply(boxes_and_rays);
BENCHMARK_CAPTURE(shadow_rays, , among_sticks)->Name("rays")->Apply(sticks_and_rays);
BENCHMARK_CAPTURE(rays_in_the_exact_time, , among_boxes)->Name("rays_in_the_exact_time")->Apply(boxes);
BENCHMARK_CAPTURE(rays_in_the_exact_time, , among_sticks)->Name("rays_in_the_exact_time")->Apply(sticks);

}  // namespace

}  // namespace hanei::bench
