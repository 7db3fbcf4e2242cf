/// Rows of unobstructed coefficients: a receiver and a patch, of an empty room and of one with desks.
#include "engine/transport/factor_rows.h"
#include "tests/bench/office.h"
#include "tests/bench/row.h"

#include <algorithm>
#include <cmath>
#include <ctime>

namespace hanei::bench {

namespace {

constexpr std::size_t side_by_side = 16;

double seconds() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

/// Seconds a pair of exact form factors, for one receiver in a hundred.
double exact_seconds(const Mesh& mesh, const Nodes& nodes) {
    std::size_t pairs = 0;
    double sum = 0.0;
    const double start = seconds();
    for (std::size_t k = 0; k < nodes.size(); k += 100, ++pairs) {
        for (const Patch& patch : mesh.patches) sum += configuration_factor(patch.outline, nodes.receivers[k]);
    }
    benchmark::DoNotOptimize(sum);
    return (seconds() - start) / static_cast<double>(pairs * mesh.patches.size());
}

void rows(benchmark::State& state, const Scene& scene, Elements elements) {
    double area = 0.0;
    const auto coarse = make_mesh(scene, 1.0);
    for (const Patch& patch : coarse->patches) area += patch.area;
    const auto mesh = make_mesh(scene, std::sqrt(area / static_cast<double>(state.range(0))));
    const Nodes nodes = nodes_of(*mesh, elements);
    const FactorRows factors(*mesh, nodes);
    std::vector<float> values(side_by_side * factors.columns());
    std::size_t first = 0;
    double pairs = 0.0;
    const double start = seconds();
    for (auto _ : state) {
        const std::size_t count = std::min(side_by_side, nodes.size() - first);
        std::fill(values.begin(), values.end(), 0.0F);
        factors.write(std::span(nodes.receivers).subspan(first, count), values.data());
        benchmark::DoNotOptimize(values.data());
        first = first + count < nodes.size() ? first + count : 0;
        pairs += static_cast<double>(count * mesh->patches.size());
    }
    Row row;
    row.ns_per_pair = 1e9 * (seconds() - start) / pairs;
    row.time_over_exact = 1e-9 * row.ns_per_pair / exact_seconds(*mesh, nodes);
    row.report(state);
}

void patches(benchmark::internal::Benchmark* each) {
    each->ArgName("patches");
    for (const int count : {500, 1000, 2000, 5000}) each->Arg(count);
}

BENCHMARK_CAPTURE(rows, constant, sample::box_room(6.0, 4.0, 3.0), Elements::constant)->Apply(patches);
BENCHMARK_CAPTURE(rows, linear, sample::box_room(6.0, 4.0, 3.0), Elements::linear)->Apply(patches);
BENCHMARK_CAPTURE(rows, constant_among_desks, room_with_desks(), Elements::constant)->Apply(patches);
BENCHMARK_CAPTURE(rows, linear_among_desks, room_with_desks(), Elements::linear)->Apply(patches);

}  // namespace

}  // namespace hanei::bench
