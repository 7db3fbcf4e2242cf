/// What every row of the benchmarks' CSV says beside its time. Google Benchmark wants the same
/// columns in every row: "nan" where a row has no such figure.
#pragma once

#include <benchmark/benchmark.h>
#include <limits>

namespace hanei::bench {

inline constexpr double no_figure = std::numeric_limits<double>::quiet_NaN();

struct Row {
    double umbra = no_figure, penumbra = no_figure, lit = no_figure;  ///< shares of the pairs
    double samples = no_figure;                                       ///< rays a pair
    double error_rms = no_figure, error_max = no_figure;              ///< of the brightest unobstructed value
    double time_over_exact = no_figure;  ///< this way's time over the exact answer's, both measured here
    double ns_per_pair = no_figure;      ///< of a receiver and a patch
    double edges = no_figure;            ///< of the loops of one iteration

    void report(benchmark::State& state) const {
        using benchmark::Counter;
        state.counters["umbra"] = umbra;
        state.counters["penumbra"] = penumbra;
        state.counters["lit"] = lit;
        state.counters["samples"] = samples;
        state.counters["error_rms"] = error_rms;
        state.counters["error_max"] = error_max;
        state.counters["time_over_exact"] = time_over_exact;
        state.counters["ns_per_pair"] = ns_per_pair;
        state.counters["ns_per_edge"] = Counter(1e-9 * edges, Counter::kIsIterationInvariantRate | Counter::kInvert);
    }
};

}  // namespace hanei::bench
