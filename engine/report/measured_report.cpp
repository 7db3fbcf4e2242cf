#include "engine/report/measured_report.h"

#include "engine/report/numbers.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace hanei {
namespace {

using Json = nlohmann::ordered_json;

std::string percent(double share) { return fmt::format("{:.2f}", 100.0 * share); }

std::string within(std::size_t count, std::size_t of) {
    return of > 0 ? fmt::format("{} of {}", count, of) : std::string("-");
}

Json to_json(const MeasuredSet::Deviation& deviation) {
    return {{"mean", deviation.mean}, {"p95", deviation.p95}, {"max", deviation.max}};
}

Json to_json(const MeasuredPair& pair, const std::string& set) {
    Json json{{"line", pair.theirs.line},
              {"set", set},
              {"position", {pair.position.x, pair.position.y, pair.position.z}},
              {"theirs_lx", pair.theirs.lux},
              {"ours_lx", pair.ours},
              {"difference_lx", pair.difference()},
              {"error_bar_lx", pair.error_bar}};
    if (pair.theirs.uncertainty) json["uncertainty_lx"] = *pair.theirs.uncertainty;
    return json;
}

}  // namespace

std::string largest_text(const MeasuredComparison& comparison, const MeasuredSet& set) {
    const MeasuredPair& pair = comparison.pairs[set.largest];
    const std::string bar = has_bound(pair.error_bar) ? fmt::format(" ± {:.2g}", pair.error_bar) : std::string();
    const std::string index = pair.theirs.index ? fmt::format(" {}", *pair.theirs.index) : std::string();
    return fmt::format("line {}: {}{} at {:.3f}, {:.3f}, {:.3f}: theirs {:.5g}, ours {:.5g}{} lx", pair.theirs.line,
                       comparison.sets[pair.set].name, index, pair.position.x, pair.position.y, pair.position.z,
                       pair.theirs.lux, pair.ours, bar);
}

std::string measured_text(const MeasuredComparison& comparison) {
    std::string text = fmt::format("compared with {}\n{:<24} {:>6} {:>9} {:>9}  {:>26}  {:>20}  {:>13} {:>13}\n",
                                   comparison.file, "set", "points", "theirs", "ours", "mean / p95 / max off, lx",
                                   "the same in %", "in our bar", "in theirs");
    for (const MeasuredSet& set : comparison.sets) {
        const auto three = [](const auto& a, const auto& b, const auto& c) {
            return fmt::format("{} / {} / {}", a, b, c);
        };
        const auto lx = [](double value) { return fmt::format("{:.2f}", value); };
        text += fmt::format("{:<24} {:>6} {:>9.1f} {:>9.1f}  {:>26}  {:>20}  {:>13} {:>13}\n", set.name, set.points,
                            set.theirs, set.ours, three(lx(set.lux.mean), lx(set.lux.p95), lx(set.lux.max)),
                            three(percent(set.share.mean), percent(set.share.p95), percent(set.share.max)),
                            within(set.within_ours, set.points), within(set.within_theirs, set.with_theirs));
    }
    for (const MeasuredSet& set : comparison.sets)
        text += fmt::format("largest, {}: {}\n", set.name, largest_text(comparison, set));
    if (!comparison.sets.empty() && comparison.sets.back().with_theirs > 0)
        text += fmt::format("{} are no further apart than both error bars together\n",
                            within(comparison.sets.back().within_both, comparison.sets.back().points));
    if (comparison.without_value > 0) text += fmt::format("{} rows have no value\n", comparison.without_value);
    if (comparison.inside > 0)
        text += fmt::format("{} values are left out: their places are inside solids here\n", comparison.inside);
    return text;
}

std::string measured_csv(const MeasuredComparison& comparison) {
    std::string text = "line,set,index,x_m,y_m,z_m,theirs_lx,uncertainty_lx,ours_lx,error_lx,difference_lx\n";
    for (const MeasuredPair& pair : comparison.pairs) {
        const auto maybe = [](const auto& value) { return value ? fmt::format("{}", *value) : std::string(); };
        text += fmt::format("{},{},{},{},{},{},{},{},{},{},{}\n", pair.theirs.line,
                            csv_field(comparison.sets[pair.set].name), maybe(pair.theirs.index), pair.position.x,
                            pair.position.y, pair.position.z, pair.theirs.lux, maybe(pair.theirs.uncertainty),
                            pair.ours, pair.error_bar, pair.difference());
    }
    return text;
}

std::string measured_json(const MeasuredComparison& comparison) {
    Json json{{"file", comparison.file},
              {"without_value", comparison.without_value},
              {"inside_solids", comparison.inside},
              {"sets", Json::array()},
              {"points", Json::array()}};
    for (const MeasuredSet& set : comparison.sets)
        json["sets"].push_back({{"name", set.name},
                                {"points", set.points},
                                {"theirs_mean_lx", set.theirs},
                                {"ours_mean_lx", set.ours},
                                {"deviation_lx", to_json(set.lux)},
                                {"deviation_share", to_json(set.share)},
                                {"within_our_error_bar", set.within_ours},
                                {"with_their_uncertainty", set.with_theirs},
                                {"within_their_uncertainty", set.within_theirs},
                                {"within_both", set.within_both},
                                {"largest", to_json(comparison.pairs[set.largest], set.name)}});
    for (const MeasuredPair& pair : comparison.pairs)
        json["points"].push_back(to_json(pair, comparison.sets[pair.set].name));
    return json.dump(2);
}

}  // namespace hanei
