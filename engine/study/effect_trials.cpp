#include "engine/study/effect_trials.h"

#include "engine/study/sweep_run.h"

#include <algorithm>
#include <cmath>

namespace hanei {
namespace {

constexpr int most_runs = 3;
constexpr double long_run = 2000.0;  // ms

/// A scene and settings that leave something out.
struct Variant {
    std::optional<Effect> effect;
    SceneSnapshot scene;
    Settings settings;
    bool shadows_between = true;
    double bound_lux = -1.0;
};

Settings with_everything(Settings settings) {
    for (const EffectOption& option : effect_options) settings.*option.member = EffectChoice::always;
    settings.tolerance_lux = 0.0;
    return settings;
}

SceneSnapshot with_measured_openings_as_points(const Scene& scene) {
    Scene changed = scene;
    for (Luminaire& luminaire : changed.luminaires)
        if (std::holds_alternative<MeasuredOpening>(luminaire.opening)) luminaire.opening = PointOpening{};
    return std::make_shared<const Scene>(std::move(changed));
}

std::vector<Variant> variants_of(const SceneSnapshot& scene, const Settings& settings) {
    const Settings everything = with_everything(settings);
    std::vector<Variant> variants;
    for (const PlannedEffect& row : plan_effects(*scene, everything).effects) {
        if (row.state != EffectState::simulated) continue;
        Variant variant{row.effect, scene, everything, true, -1.0};
        // Bounds of shadows and openings are of light straight from luminaires, not of what it is reflected to.
        if (row.may_be_skipped || row.effect == Effect::occlusion_patches) variant.bound_lux = row.bound_lux;
        if (const EffectOption* const option = option_of(row.effect)) {
            variant.settings.*option->member = EffectChoice::never;
            // Of furniture the row's bound is that of one piece; all of it is left out here.
            if (row.effect == Effect::furniture) variant.bound_lux = plan_effects(*scene, variant.settings).skipped_lux;
        } else if (row.effect == Effect::occlusion_patches && settings.method != Method::linear) {
            variant.shadows_between = false;
        } else if (row.effect == Effect::opening_size) {
            variant.scene = with_measured_openings_as_points(*scene);
        } else {
            continue;
        }
        variants.push_back(std::move(variant));
    }
    const EffectsPlan plan = plan_effects(*scene, settings, PlanDetail::decisions);
    if (plan.skipped_lux > 0.0) variants.push_back({std::nullopt, scene, settings, true, plan.skipped_lux});
    return variants;
}

/// The soonest of a few runs from nothing: what else the machine does hardly counts.
std::optional<SweepAnswer> timed(const Variant& variant, const Work& work) {
    std::optional<SweepAnswer> best;
    for (int k = 0; k < most_runs && !(best && best->milliseconds > long_run); ++k) {
        SweepRun run(variant.scene, variant.settings, variant.shadows_between, {});
        auto answer = run.with_bounces(variant.settings.bounces, {work.threads, work.stop, nullptr});
        if (!answer) return std::nullopt;
        if (!best || answer->milliseconds < best->milliseconds) best = std::move(answer);
    }
    return best;
}

/// Calculation points and then grids, as values are compared.
std::vector<PointResult> places_of(const Solution& solution) {
    std::vector<PointResult> places = solution.points;
    for (const GridResult& grid : solution.grids) places.insert(places.end(), grid.points.begin(), grid.points.end());
    return places;
}

void compare(EffectTrial& trial, const Solution& with, const Solution& without) {
    const std::vector<PointResult> a = places_of(with), b = places_of(without);
    double sum = 0.0;
    std::size_t compared = 0;
    for (std::size_t k = 0; k < std::min(a.size(), b.size()); ++k) {
        if (a[k].value.inside_solid) continue;
        const double change = std::abs(a[k].value.total().value - b[k].value.total().value);
        sum += change;
        ++compared;
        if (change < trial.change_lux) continue;
        trial.change_lux = change;
        trial.position = a[k].position;
    }
    if (compared > 0) trial.mean_change_lux = sum / static_cast<double>(compared);
}

}  // namespace

const EffectTrial* EffectTrials::of(std::optional<Effect> effect) const {
    const auto found =
        std::find_if(trials.begin(), trials.end(), [&](const EffectTrial& trial) { return trial.effect == effect; });
    return found == trials.end() ? nullptr : &*found;
}

std::optional<EffectTrials> try_effects(const SceneSnapshot& scene, const Settings& settings, const Work& work) {
    const std::vector<Variant> variants = variants_of(scene, settings);
    const auto tell = [&](std::size_t done) {
        if (work.progress) work.progress->advance(static_cast<float>(done) / static_cast<float>(variants.size() + 1));
    };
    tell(0);
    const auto everything = timed({std::nullopt, scene, with_everything(settings)}, work);
    if (!everything) return std::nullopt;
    EffectTrials trials;
    trials.everything_ms = everything->milliseconds;
    trials.places = places_of(*everything->solution).size();
    for (const Variant& variant : variants) {
        tell(trials.trials.size() + 1);
        const auto without = timed(variant, work);
        if (!without) return std::nullopt;
        EffectTrial& trial = trials.trials.emplace_back();
        trial.effect = variant.effect;
        trial.bound_lux = variant.bound_lux;
        trial.without_ms = without->milliseconds;
        trial.saved_ms = everything->milliseconds - without->milliseconds;
        compare(trial, *everything->solution, *without->solution);
    }
    return trials;
}

}  // namespace hanei
