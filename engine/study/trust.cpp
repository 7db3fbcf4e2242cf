#include "engine/study/trust.h"

#include "engine/direct/light_on_luminaires.h"
#include "engine/study/display_stage.h"
#include "engine/study/study.h"
#include "engine/study/trust_exchange.h"

#include <algorithm>
#include <cmath>

namespace hanei {
namespace {

/// What of the answer's direct light arrives on patches; the errors of means over them, and whose light is missing,
/// are asked for once more, one luminaire after another.
std::optional<DirectTrust> direct_trust(const Solution& solution, const Work& work) {
    const Mesh& mesh = *solution.mesh;
    const OccluderSet* const occluders =
        solution.plan.simulates(Effect::occlusion_direct) ? solution.occluders.get() : nullptr;
    const Accuracy accuracy{std::clamp(3.0 * solution.settings.accuracy, 1e-3, 1e-2), 0.0};
    std::vector<ReceivingPolygon> polygons;
    for (const Patch& patch : mesh.patches) polygons.push_back({patch.outline, mesh.faces[patch.face].face.normal});
    DirectTrust trust;
    trust.open = !solution.scene->room;
    for (std::size_t p = 0; p < mesh.patches.size(); ++p)
        trust.arrived += mesh.patches[p].area * solution.patch_direct[p];
    for (const WeightedEmitter& weighted : emitters_of(*solution.scene)) {
        const auto means = mean_direct_estimates(weighted.emitter, polygons, occluders, accuracy, work);
        if (!means) return std::nullopt;
        double arrived = 0.0, error = 0.0, on_luminaires = 0.0;
        for (std::size_t p = 0; p < polygons.size(); ++p) {
            arrived += mesh.patches[p].area * (*means)[p];
            error += mesh.patches[p].area * (*means)[polygons.size() + p];
        }
        if (occluders) {
            const auto met = flux_on_luminaires(weighted.emitter, *solution.scene, *occluders, accuracy, work);
            if (!met) return std::nullopt;
            on_luminaires = met->value;
            error += met->error;
        }
        const double emitted = weighted.share * weighted.emitter.flux().value;
        const double missing = emitted - weighted.share * (arrived + on_luminaires);
        trust.emitted += emitted;
        trust.on_luminaires += weighted.share * on_luminaires;
        trust.error += weighted.share * error;
        if (std::abs(missing) <= std::abs(trust.worst_missing)) continue;
        trust.worst = weighted.emitter.luminaire();
        trust.worst_emitted = emitted;
        trust.worst_missing = missing;
    }
    return trust;
}

/// The scene with every other luminaire dark; what shines by itself goes with the first half.
std::shared_ptr<const Scene> half_of(const Scene& scene, bool first) {
    Scene half = scene;
    bool lit = first;
    for (Luminaire& luminaire : half.luminaires) {
        if (!(luminaire.dimming > 0.0)) continue;
        if (!lit) luminaire.dimming = 0.0;
        lit = !lit;
    }
    if (!first)
        for (FreeSurface& surface : half.surfaces) surface.own_exitance = {};
    return std::make_shared<const Scene>(std::move(half));
}

std::size_t lights_in(const Scene& scene) {
    const auto shines = [](const FreeSurface& surface) { return surface.own_exitance.value > 0.0; };
    const auto lit = [](const Luminaire& luminaire) { return luminaire.dimming > 0.0; };
    return static_cast<std::size_t>(std::count_if(scene.luminaires.begin(), scene.luminaires.end(), lit)) +
           (std::any_of(scene.surfaces.begin(), scene.surfaces.end(), shines) ? 1 : 0);
}

std::optional<AdditivityTrust> additivity_trust(const Solution& whole, const Settings& settings, const Work& work) {
    const auto odd = half_of(*whole.scene, true), even = half_of(*whole.scene, false);
    AdditivityTrust trust;
    if (lights_in(*odd) > 0 && lights_in(*even) > 0) {
        const auto one = Study().run(odd, settings, {}, work);
        const auto other = one ? Study().run(even, settings, {}, work) : nullptr;
        if (!other) return std::nullopt;
        trust = sum_of_parts(whole, *one, *other);
    }
    trust.odd = lights_in(*odd);
    trust.even = lights_in(*even);
    return trust;
}

std::optional<ThreadsTrust> threads_trust(const Solution& solution, Settings settings, const Work& work) {
    const int before = settings.threads;
    settings.threads = before == 1 ? 3 : 1;
    const auto again = Study().run(solution.scene, settings, {}, work);
    if (!again) return std::nullopt;
    ThreadsTrust trust = same_bits(solution, *again);
    trust.threads = {std::min(before, settings.threads), std::max(before, settings.threads)};
    return trust;
}

}  // namespace

std::optional<TrustReport> trust_in(const SceneSnapshot& scene, const Settings& settings, const Work& work,
                                    const std::function<void(const TrustReport&)>& told) {
    Settings asked = settings;
    if (asked.threads == 0) asked.threads = 3;  // whatever the machine has: more than one, and the same everywhere
    TrustReport report;
    report.solution = Study().run(scene, asked, {.energy = true}, work);
    if (!report.solution) return std::nullopt;
    const Solution& solution = *report.solution;
    const auto take = [&](auto& into, auto&& made) {
        if (!made) return false;
        into = std::move(*made);
        ++report.done;
        if (told) told(report);
        return true;
    };
    if (!take(report.direct, direct_trust(solution, work))) return std::nullopt;
    Work by_threads = work;
    by_threads.threads = asked.threads;
    ExchangeTrust exchange(solution, by_threads);
    if (solution.plan.simulates(Effect::interreflection) && solution.refusal.empty() &&
        !solution.mesh->patches.empty()) {
        if (!exchange.solve() || !take(report.energy, exchange.energy(report.direct)) ||
            !take(report.reciprocity, exchange.reciprocity()) || !take(report.closure, exchange.closure()))
            return std::nullopt;
    } else {
        report.energy.asked = report.reciprocity.asked = report.closure.asked = false;
        report.done += 3;
    }
    if (!take(report.additivity, additivity_trust(solution, asked, work)) ||
        !take(report.threads, threads_trust(solution, asked, work)))
        return std::nullopt;
    return report;
}

}  // namespace hanei
