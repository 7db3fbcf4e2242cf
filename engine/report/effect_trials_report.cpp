#include "engine/report/effect_trials_report.h"

#include "engine/report/report_json.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace hanei {
namespace {

using Json = nlohmann::ordered_json;

std::string_view left_out(const EffectTrial& trial) {
    return trial.effect ? name_of(*trial.effect) : "all that the plan skips";
}

std::string bound_text(double lux) { return lux < 0.0 ? "-" : fmt::format("{:.3g}", lux); }

}  // namespace

std::string trials_text(const EffectTrials& trials) {
    std::string text = fmt::format(
        "\nMeasured here: {:.4g} ms with everything; values compared at {} calculation points\n"
        "{:<26} {:>9} {:>9} {:>12} {:>9} {:>10}  {}\n",
        trials.everything_ms, trials.places, "without", "time ms", "saved ms", "changes <= lx", "mean lx", "bound lx",
        "most at (m)");
    for (const EffectTrial& trial : trials.trials)
        text += fmt::format("{:<26} {:>9.4g} {:>9.3g} {:>13.3g} {:>9.3g} {:>10}  ({:.2f}, {:.2f}, {:.2f})\n",
                            left_out(trial), trial.without_ms, trial.saved_ms, trial.change_lux, trial.mean_change_lux,
                            bound_text(trial.bound_lux), trial.position.x, trial.position.y, trial.position.z);
    if (trials.trials.empty()) text += "Nothing in this scene can be left out.\n";
    return text;
}

std::string plan_json(const EffectsPlan& plan, const EffectTrials& trials) {
    Json measured{{"everything_ms", trials.everything_ms}, {"calculation_points", trials.places}};
    measured["without"] = Json::array();
    for (const EffectTrial& trial : trials.trials) {
        Json row{{"effect", left_out(trial)},
                 {"time_ms", trial.without_ms},
                 {"saved_ms", trial.saved_ms},
                 {"change_lx", trial.change_lux},
                 {"mean_change_lx", trial.mean_change_lux},
                 {"position_m", {trial.position.x, trial.position.y, trial.position.z}}};
        if (trial.bound_lux >= 0.0) row["bound_lx"] = trial.bound_lux;
        measured["without"].push_back(std::move(row));
    }
    return Json{{"plan", Json::parse(plan_json(plan))}, {"measured", std::move(measured)}}.dump(2) + '\n';
}

}  // namespace hanei
