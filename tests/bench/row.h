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
    double unknowns = no_figure;         ///< of a study or of stored rows
    double direct_ms = no_figure, factors_ms = no_figure, balance_ms = no_figure;  ///< of one run, by stage
    double gather_ms = no_figure, display_ms = no_figure, other_ms = no_figure;    ///< other: plan and mesh
    double cancel_ms = no_figure;  ///< from the wish to stop to the return
    double rows_mb = no_figure;    ///< in memory
    double on_disk = no_figure;    ///< 1 when some rows are
    double peak_mb = no_figure;    ///< resident memory of the process

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
        state.counters["unknowns"] = unknowns;
        state.counters["direct_ms"] = direct_ms;
        state.counters["factors_ms"] = factors_ms;
        state.counters["balance_ms"] = balance_ms;
        state.counters["gather_ms"] = gather_ms;
        state.counters["display_ms"] = display_ms;
        state.counters["other_ms"] = other_ms;
        state.counters["cancel_ms"] = cancel_ms;
        state.counters["rows_mb"] = rows_mb;
        state.counters["on_disk"] = on_disk;
        state.counters["peak_mb"] = peak_mb;
        state.counters["ns_per_edge"] = Counter(1e-9 * edges, Counter::kIsIterationInvariantRate | Counter::kInvert);
    }
};

}  // namespace hanei::bench
