/// Whole studies of the office: from nothing, after an edit, stopped on the way; and rows past memory.
#include "engine/base/tiles.h"
#include "engine/scene/colour.h"
#include "engine/study/rows_stage.h"
#include "engine/study/study.h"
#include "tests/bench/memory.h"
#include "tests/bench/office.h"
#include "tests/bench/row.h"

#include <chrono>
#include <functional>
#include <map>
#include <thread>

namespace hanei::bench {

namespace {

using Clock = std::chrono::steady_clock;
using Edit = std::function<void(Scene&, bool there)>;

double ms_since(Clock::time_point begin) {
    return std::chrono::duration<double, std::milli>(Clock::now() - begin).count();
}

SceneSnapshot snapshot(Scene scene) { return std::make_shared<const Scene>(std::move(scene)); }

Settings settings_for(const Scene& scene, Method method, std::int64_t unknowns) {
    Settings settings;
    settings.method = method;
    settings.max_patch = width_for(scene, method, static_cast<double>(unknowns));
    return settings;
}

/// Milliseconds by stage, means over the iterations.
class StageSums {
public:
    void add(const Solution& solution) {
        ++runs_;
        for (const StageTime& time : solution.times) sums_[time.stage] += time.ms;
        unknowns_ = static_cast<double>(solution.exitance.size());
    }
    void into(Row& row) const {
        const auto mean = [&](Stage stage) {
            const auto found = sums_.find(stage);
            return found == sums_.end() ? 0.0 : found->second / runs_;
        };
        row.unknowns = unknowns_;
        row.direct_ms = mean(Stage::direct);
        row.factors_ms = mean(Stage::factors);
        row.balance_ms = mean(Stage::balance);
        row.gather_ms = mean(Stage::gathering);
        row.display_ms = mean(Stage::refining);
        row.other_ms = mean(Stage::planning) + mean(Stage::meshing);
        row.peak_mb = peak_memory_mb();
    }

private:
    std::map<Stage, double> sums_;
    double runs_ = 0.0, unknowns_ = 0.0;
};

void cold(benchmark::State& state, Method method) {
    const SceneSnapshot scene = snapshot(lit_office());
    const Settings settings = settings_for(*scene, method, state.range(0));
    StageSums sums;
    forget_peak_memory();
    for (auto _ : state) sums.add(*Study().run(scene, settings, StudyRequest{.mesh_error = false}, Work{}));
    Row row;
    sums.into(row);
    row.report(state);
}

/// As the window asks while something is dragged; the edit is made and unmade in turn.
void edited(benchmark::State& state, Method method, const Edit& edit) {
    Scene scene = lit_office();
    const Settings settings = settings_for(scene, method, state.range(0));
    const StudyRequest live{.display = true, .live = true, .mesh_error = false};
    Study study;
    study.run(snapshot(scene), settings, live, Work{});
    StageSums sums;
    bool there = false;
    forget_peak_memory();
    for (auto _ : state) {
        there = !there;
        edit(scene, there);
        sums.add(*study.run(snapshot(scene), settings, live, Work{}));
    }
    Row row;
    sums.into(row);
    row.report(state);
}

/// From the wish to stop until the study returns, the longest of several moments of its run.
void cancelled(benchmark::State& state, Method method) {
    const SceneSnapshot scene = snapshot(lit_office());
    const Settings settings = settings_for(*scene, method, state.range(0));
    const StudyRequest request{.display = true};
    const auto begin = Clock::now();
    const auto whole = Study().run(scene, settings, request, Work{});
    const double whole_ms = ms_since(begin);
    Row row;
    row.unknowns = static_cast<double>(whole->exitance.size());
    row.cancel_ms = 0.0;
    for (auto _ : state) {
        double longest = 0.0;
        for (const double share : {0.05, 0.2, 0.35, 0.5, 0.65, 0.8, 0.95}) {
            std::stop_source stop;
            std::thread run([&] { Study().run(scene, settings, request, Work{.stop = stop.get_token()}); });
            std::this_thread::sleep_for(std::chrono::duration<double, std::milli>(share * whole_ms));
            const auto wish = Clock::now();
            stop.request_stop();
            run.join();
            longest = std::max(longest, ms_since(wish));
        }
        state.SetIterationTime(1e-3 * longest);
        row.cancel_ms = std::max(row.cancel_ms, longest);
    }
    row.report(state);
}

/// Rows alone, within 1024 MB: how long they take to make, and a product with them.
void stored(benchmark::State& state) {
    const Scene scene = lit_office();
    const double width = width_for(scene, Method::patch, static_cast<double>(state.range(0)));
    const auto mesh = make_mesh(scene, width);
    const Nodes nodes = nodes_of(*mesh, Elements::constant);
    constexpr std::size_t memory = std::size_t{1024} * 1024 * 1024;
    RowsInput input;
    input.mesh = mesh;
    input.nodes = std::make_shared<const Nodes>(nodes);
    input.geometry = input.receivers_are = mesh;
    input.receivers = input.nodes->receivers;
    input.occluders = std::make_shared<const OccluderSet>(occluders_of(scene));
    input.storage = {RowFormat::compact, memory};
    const Work work{.threads = hardware_threads()};
    forget_peak_memory();
    const auto begin = Clock::now();
    const auto rows = make_rows(input, work);
    Row row;
    row.factors_ms = ms_since(begin);
    const std::vector<double> leaving(nodes.size(), 100.0);
    std::vector<double> arriving(nodes.size());
    for (auto _ : state) {
        rows->multiply(leaving, arriving, 1, work);
        benchmark::DoNotOptimize(arriving.data());
    }
    row.unknowns = static_cast<double>(nodes.size());
    row.rows_mb = static_cast<double>(rows->bytes_in_memory()) / (1024.0 * 1024.0);
    row.on_disk = rows->on_disk() ? 1.0 : 0.0;
    row.peak_mb = peak_memory_mb();
    row.report(state);
}

void luminaire_moved(Scene& scene, bool there) { scene.luminaires.front().position.x += there ? 0.2 : -0.2; }
void desk_moved(Scene& scene, bool there) { scene.furniture.front().position.x += there ? 0.2 : -0.2; }
void recoloured(Scene& scene, bool there) { scene.materials.front().reflectance += there ? 0.1 : -0.1; }
void dimmed(Scene& scene, bool there) { scene.luminaires.front().dimming = there ? 0.4 : 1.0; }

void timed(benchmark::internal::Benchmark* each) {
    each->ArgName("unknowns")->Unit(benchmark::kMillisecond)->UseRealTime()->MeasureProcessCPUTime();
}
void by_patches(benchmark::internal::Benchmark* each) {
    timed(each);
    for (const int count : {200, 1000, 5000, 20000}) each->Arg(count);
}
void by_linear(benchmark::internal::Benchmark* each) {
    timed(each);
    for (const int count : {1000, 5000}) each->Arg(count);
}

BENCHMARK_CAPTURE(cold, patch, Method::patch)->Name("solve/cold/patch")->Apply(by_patches);
BENCHMARK_CAPTURE(cold, linear, Method::linear)->Name("solve/cold/linear")->Apply(by_linear);
BENCHMARK_CAPTURE(edited, lp, Method::patch, luminaire_moved)->Name("solve/luminaire_moved/patch")->Apply(by_patches);
BENCHMARK_CAPTURE(edited, ll, Method::linear, luminaire_moved)->Name("solve/luminaire_moved/linear")->Apply(by_linear);
BENCHMARK_CAPTURE(edited, fp, Method::patch, desk_moved)->Name("solve/desk_moved/patch")->Apply(by_patches);
BENCHMARK_CAPTURE(edited, fl, Method::linear, desk_moved)->Name("solve/desk_moved/linear")->Apply(by_linear);
BENCHMARK_CAPTURE(edited, rp, Method::patch, recoloured)->Name("solve/recoloured/patch")->Apply(by_patches);
BENCHMARK_CAPTURE(edited, rl, Method::linear, recoloured)->Name("solve/recoloured/linear")->Apply(by_linear);
BENCHMARK_CAPTURE(edited, dp, Method::patch, dimmed)->Name("solve/dimmed/patch")->Apply(by_patches);
BENCHMARK_CAPTURE(edited, dl, Method::linear, dimmed)->Name("solve/dimmed/linear")->Apply(by_linear);

BENCHMARK_CAPTURE(cancelled, patch, Method::patch)
    ->Name("solve/cancelled/patch")
    ->ArgName("unknowns")
    ->Unit(benchmark::kMillisecond)
    ->UseManualTime()
    ->Iterations(1)
    ->Arg(200)
    ->Arg(5000)
    ->Arg(20000);

BENCHMARK(stored)->Name("solve/rows")->Apply(timed)->Arg(5000)->Arg(20000)->Arg(50000);

}  // namespace

}  // namespace hanei::bench
