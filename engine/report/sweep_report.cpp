#include "engine/report/sweep_report.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <vector>

namespace hanei {
namespace {

std::string marks_text(const SweepMarks& marks) {
    std::string text;
    const auto add = [&](std::string_view word) { text += fmt::format("{}{}", text.empty() ? "" : " ", word); };
    if (marks.current) add("current");
    if (marks.paper) add("paper's-own");
    if (marks.preset) add(name_of(*marks.preset));
    return text;
}

std::string one_line(std::string text) {
    std::replace_if(
        text.begin(), text.end(), [](char c) { return c == ',' || c == '"' || c == '\n' || c == '\r'; }, ' ');
    return text;
}

std::string errors_fields(const SweepErrors& errors) {
    return fmt::format("{},{:.6g},{:.6g},{:.6g},{:.6g},{:.6g},{:.6g}\n", one_line(errors.set), 100 * errors.mean,
                       100 * errors.p95, 100 * errors.max, errors.mean_lux, errors.p95_lux, errors.max_lux);
}

std::string run_fields(const Settings& settings, bool shadows) {
    return fmt::format("{},{:.6g},{},{},{:.3g}", name_of(settings.method), settings.max_patch, settings.bounces,
                       shadows ? "yes" : "no", 100 * settings.accuracy);
}

constexpr const char* rule = "    {:<9}{:<34}{:>11}{:>11}{:>11}{:>11}\n";

std::string presets_text(const Sweep& sweep) {
    std::string text, basis;
    for (const SweepPoint& point : sweep.points) {
        if (!point.marks.preset) continue;
        basis = basis_of(point.predicted);
        text += fmt::format(rule, name_of(*point.marks.preset), words_of(point), time_text(point.predicted.ms),
                            time_text(point.milliseconds), percent_text(point.predicted.error),
                            percent_text(point.errors.front().p95));
    }
    if (text.empty()) return {};
    return fmt::format("Presets, predicted from {} (error: 95 of 100 points are within it)\n", basis) +
           fmt::format(rule, "", "", "predicted", "took", "predicted", "found") + text;
}

std::string frontier_text(const Sweep& sweep) {
    std::vector<const SweepPoint*> best;
    for (const SweepPoint& point : sweep.points)
        if (point.on_frontier) best.push_back(&point);
    std::sort(best.begin(), best.end(),
              [](const SweepPoint* a, const SweepPoint* b) { return a->milliseconds < b->milliseconds; });
    std::string text = "Frontier: nothing is both sooner and more exact\n";
    text += fmt::format("    {:>9}{:>10}{:>10}{:>10}  {}\n", "time", "mean", "95 of 100", "greatest", "settings");
    for (const SweepPoint* point : best) {
        const SweepErrors& errors = point->errors.front();
        text += fmt::format("    {:>9}{:>10}{:>10}{:>10}  {}{}\n", time_text(point->milliseconds),
                            percent_text(errors.mean), percent_text(errors.p95), percent_text(errors.max),
                            words_of(*point), point->marks.current ? " (current)" : "");
    }
    return text;
}

}  // namespace

std::string words_of(const SweepPoint& point) {
    std::string words = fmt::format("{}, {:.2g} m", name_of(point.settings.method), point.settings.max_patch);
    if (!point.complete)
        words += fmt::format(", {} bounce{}", point.settings.bounces, point.settings.bounces == 1 ? "" : "s");
    if (!point.shadows) words += ", no shadows between surfaces";
    return words;
}

std::string basis_of(const Prediction& prediction) {
    if (prediction.studies == 0) return "figures measured elsewhere, none of this machine yet";
    return prediction.same_room ? "studies of this room on this machine" : "studies of other rooms on this machine";
}

std::string time_text(double milliseconds) {
    if (milliseconds < 9.95) return fmt::format("{:.1f} ms", milliseconds);
    if (milliseconds < 999.5) return fmt::format("{:.0f} ms", milliseconds);
    if (milliseconds < 9950.0) return fmt::format("{:.1f} s", 1e-3 * milliseconds);
    if (milliseconds < 599.5e3) return fmt::format("{:.0f} s", 1e-3 * milliseconds);
    return fmt::format("{:.0f} min", milliseconds / 60e3);
}

std::string percent_text(double share) {
    const double percent = 100.0 * share;
    if (percent >= 9.95) return percent < 1000.0 ? fmt::format("{:.0f} %", percent) : std::string("> 1000 %");
    return percent >= 0.995 ? fmt::format("{:.1f} %", percent) : fmt::format("{:.2g} %", percent);
}

std::string sweep_csv(const Sweep& sweep) {
    std::string text =
        "kind,method,max_patch_m,bounces,shadows_between_surfaces,accuracy_percent,marks,unknowns,time_ms,predicted_ms,"
        "predicted_p95_percent,frontier,set,mean_error_percent,p95_error_percent,max_error_percent,mean_error_lx,"
        "p95_error_lx,max_error_lx\n";
    for (const SweepPoint& point : sweep.points)
        for (const SweepErrors& errors : point.errors)
            text += fmt::format("run,{},{},{},{:.2f},{:.2f},{:.6g},{},", run_fields(point.settings, point.shadows),
                                marks_text(point.marks), point.unknowns, point.milliseconds, point.predicted.ms,
                                100 * point.predicted.error, point.on_frontier ? "yes" : "no") +
                    errors_fields(errors);
    if (!sweep.uncertainty.set.empty())
        text += fmt::format("reference,{}; uncertainty: {},,,,,,,,,,,", one_line(sweep.against),
                            one_line(sweep.uncertainty_words)) +
                errors_fields(sweep.uncertainty);
    if (sweep.lumen.refusal.empty())
        text += fmt::format("lumen,utilization factor,,,,,,,{:.3f},,,,mean of the working plane,{:.6g},,,{:.6g},,\n",
                            sweep.lumen.milliseconds, 100 * sweep.lumen.error(),
                            std::abs(sweep.lumen.predicted - sweep.lumen.solved));
    for (const OmittedRun& run : sweep.left_out)
        text +=
            fmt::format("left out,{},,,,{:.2f},,,,,,,,,\n", run_fields(run.settings, run.shadows), run.predicted_ms);
    return text;
}

std::string sweep_text(const Sweep& sweep) {
    if (sweep.points.empty())
        return sweep.stopped ? std::string("Stopped before the first run.\n")
                             : fmt::format("No run fits into {:.3g} s: allow more time, or take wider patches.\n",
                                           sweep.budget_s);
    std::string text = fmt::format("Errors are against {}.\n", sweep.against);
    const SweepErrors& sure = sweep.uncertainty;
    if (!sure.set.empty())
        text += fmt::format("It is uncertain itself by {} on the mean, {} at 95 of 100 points and {} at most: {}.\n",
                            percent_text(sure.mean), percent_text(sure.p95), percent_text(sure.max),
                            sweep.uncertainty_words);
    if (!sweep.something_between) text += "Nothing stands between surfaces: their shadows are not tried.\n";
    text += fmt::format("\n{}\n{}\n", presets_text(sweep), frontier_text(sweep));
    if (sweep.lumen.refusal.empty())
        text +=
            fmt::format("Lumen method: {:.0f} lx on the working plane ({:.2f} m) in {}; solved {:.0f} lx: {} off.\n",
                        sweep.lumen.predicted, sweep.lumen.working_plane, time_text(sweep.lumen.milliseconds),
                        sweep.lumen.solved, percent_text(sweep.lumen.error()));
    else
        text += fmt::format("Lumen method: none, for {}.\n", sweep.lumen.refusal);
    std::string left_out;
    for (const OmittedRun& run : sweep.left_out)
        left_out += fmt::format("{}{} {:.2g} m{} ({})", left_out.empty() ? "" : ", ", name_of(run.settings.method),
                                run.settings.max_patch, run.shadows ? "" : " without shadows between surfaces",
                                time_text(run.predicted_ms));
    if (!left_out.empty()) text += fmt::format("Left out, for they take longer than was left: {}.\n", left_out);
    text +=
        fmt::format("{} runs in {:.1f} s of {:.0f} s, {:.1f} s of processor time{}.\n", sweep.points.size(),
                    sweep.spent_s, sweep.budget_s, sweep.processor_s, sweep.stopped ? "; stopped before the end" : "");
    return text;
}

}  // namespace hanei
