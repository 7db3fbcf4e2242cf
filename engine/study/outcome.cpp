#include "engine/study/outcome.h"

#include "engine/study/value_stage.h"

#include <algorithm>
#include <fmt/format.h>
#include <string>

namespace hanei {

namespace {

/// A gain on every reflection changes a room's interreflected light by gain / (1 - mean reflectance); a
/// quarter of that was not reached in 95 of 100 values. Where nothing absorbs, light is lost by openings alone:
/// there by the gain times how much light leaves surfaces of what first leaves them.
double closure_error(const Solution& solution) {
    const PerPatch<double> reflectance = reflectances(*solution.mesh, *solution.scene);
    double area = 0.0, reflecting = 0.0, first = 0.0, all = 0.0;
    for (std::size_t p = 0; p < solution.mesh->patches.size(); ++p) {
        const Patch& patch = solution.mesh->patches[p];
        const double passed_on = patch.area * reflectance.all()[p];
        area += patch.area;
        reflecting += passed_on;
        first += patch.area * patch.own_exitance.value + passed_on * solution.patch_direct[p];
        all += passed_on * solution.patch_interreflected[p];
    }
    constexpr double likely = 0.25, nothing_absorbed = 1e-9;
    if (area - reflecting > nothing_absorbed * area) return likely * solution.closure * area / (area - reflecting);
    return first > 0.0 ? likely * solution.closure * (first + all) / first : 0.0;
}

/// More light passes between surfaces than any room could keep: each reflection leaves at most the greatest
/// reflectance of it, so that all together are at most 1 / (1 - that) of what leaves first.
bool is_beyond_any_room(const Solution& solution) {
    const PerPatch<double> reflectance = reflectances(*solution.mesh, *solution.scene);
    double first = 0.0, received = 0.0, greatest = 0.0;
    for (std::size_t p = 0; p < solution.mesh->patches.size(); ++p) {
        const Patch& patch = solution.mesh->patches[p];
        first += patch.area * (patch.own_exitance.value + reflectance.all()[p] * solution.patch_direct[p]);
        received += patch.area * solution.patch_interreflected[p];
        greatest = std::max(greatest, reflectance.all()[p]);
    }
    return !(received * (1.0 - greatest) <= first);  // what is no number is beyond as well
}

}  // namespace

void take_answer(Solution& solution, const Level& level, const LevelAnswer& answer) {
    solution.patch_direct = answer.patch_direct;
    const auto of_nodes = [&](LightField field) { return level.node_values(mixed(answer.parts, field)); };
    solution.patch_interreflected = level.patch_values(mixed(answer.parts, &SideLight::interreflected));
    solution.nodes_a_patch = static_cast<int>(level.now().nodes->per_patch);
    solution.exitance = of_nodes(&SideLight::exitance);
    solution.exitance_half_width = of_nodes(&SideLight::exitance_half_width);
    solution.bounces = answer.bounces;
    solution.converged = answer.converged;
    solution.greatest_row_sum = answer.greatest_row_sum;
    solution.closure = answer.greatest_gain;
    solution.reflected_error = closure_error(solution);
    const PatchLight light{solution.patch_direct, solution.patch_interreflected};
    solution.face_means = face_means(*solution.mesh, light, solution.plan.skipped_anywhere_lux);
    solution.refusal = answer.refusal;
    solution.iteration_bound = 0.0;
    for (const double half_width : solution.exitance_half_width)
        solution.iteration_bound = std::max(solution.iteration_bound, half_width);
}

void take_times(Solution& solution, std::vector<StageTime> times) {
    solution.times = std::move(times);
    const auto ms_of = [&](std::initializer_list<Stage> stages) {
        double ms = 0.0;
        for (const StageTime& time : solution.times)
            if (std::find(stages.begin(), stages.end(), time.stage) != stages.end()) ms += time.ms;
        return ms;
    };
    for (PlannedEffect& effect : solution.plan.effects) {
        if (effect.state != EffectState::simulated) continue;
        if (effect.effect == Effect::occlusion_direct) effect.measured_ms = ms_of({Stage::direct});
        if (effect.effect == Effect::interreflection) effect.measured_ms = ms_of({Stage::factors, Stage::balance});
        if (effect.effect == Effect::bounces) effect.measured_ms = ms_of({Stage::balance});
    }
}

void note_width(Solution& solution) {
    if (solution.patch_width <= solution.settings.max_patch) return;
    solution.notes.push_back(
        fmt::format("Patches of {:.3g} m would be more than can be solved: computed with patches of {:.3g} m.",
                    solution.settings.max_patch, solution.patch_width));
}

void note_divergence(Solution& solution) {
    constexpr double rounding = 1e-6;  // of form factors kept as floats
    const std::string sum = std::to_string(solution.greatest_row_sum);
    if (!solution.refusal.empty()) return;
    const bool too_large = is_of_the_paper(solution.settings.method) && solution.greatest_row_sum > 1.0 + rounding;
    if (too_large && is_beyond_any_room(solution)) {
        solution.notes.push_back("Divergent: the paper's form factors add up to more than 1 (with the reflectance, " +
                                 sum +
                                 "), where grid points all but touch, and light grows from reflection to reflection. "
                                 "The interreflected figures here are no light. Use method patch.");
    } else if (too_large) {
        solution.notes.push_back("The paper's form factors add up to more than 1 (with the reflectance, " + sum +
                                 "): interreflection is wrong where patches come close. Use method patch.");
    } else if (!solution.converged && solution.bounces >= solution.settings.bounces) {
        solution.notes.push_back("Stopped after " + std::to_string(solution.bounces) +
                                 " bounces as set; the rest is in the error bars.");
    }
}

}  // namespace hanei
