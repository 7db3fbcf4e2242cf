#include "engine/study/direct_stage.h"

#include "engine/scene/dimmers.h"
#include "engine/study/stage_keys.h"

#include <algorithm>
#include <numeric>

namespace hanei {

namespace {

bool is_accurate_enough(const Accuracy& kept, const LightReceivers& receivers) {
    if (kept == receivers.accuracy) return true;
    return receivers.finer_will_do && kept.share <= receivers.accuracy.share && kept.floor <= receivers.accuracy.floor;
}

}  // namespace

double output_share(const Scene& scene, const Luminaire& luminaire) {
    return dimming_of(scene, luminaire) * scene.maintenance_factor;
}

/// Receivers whose sight to the luminaire one of the bodies may cut.
std::vector<std::uint32_t> DirectStage::touched(const Emitter& emitter, const LightReceivers& receivers,
                                                const BodyChanges& changes) {
    std::vector<std::uint32_t> found;
    std::vector<BodyIndex> between;
    for (std::uint32_t k = 0; k < receivers.count; ++k) {
        between.clear();
        changes.gone.between(receivers.places(k), emitter.extent(), between);
        if (between.empty()) changes.come.between(receivers.places(k), emitter.extent(), between);
        if (!between.empty()) found.push_back(k);
    }
    return found;
}

DirectStage::Values DirectStage::of(const Scene& scene, const Luminaire& luminaire, const LightReceivers& receivers,
                                    const std::shared_ptr<const OccluderSet>& occluders) {
    Luminaire light = light_of(luminaire);
    const Photometry* const photometry = measured_of(scene, luminaire);
    Entry& kept = entries_[luminaire.id];
    const bool same = kept.values && kept.light == light && kept.receivers == receivers.identity &&
                      is_accurate_enough(kept.accuracy, receivers) &&
                      (photometry ? kept.photometry == *photometry : !kept.photometry);
    if (same && kept.occluders == occluders) return kept.values;

    const Emitter emitter(scene, luminaire);
    std::vector<std::uint32_t> which(receivers.count);
    std::iota(which.begin(), which.end(), 0U);
    std::vector<double> values;
    if (same && kept.occluders && occluders) {
        const BodyChanges& changes = changes_.between(kept.occluders, occluders);
        if (!changes.most) {
            which = touched(emitter, receivers, changes);
            values = *kept.values;
        }
    }
    if (same && which.empty()) {
        kept.occluders = occluders;
        return kept.values;
    }
    reused_ = false;
    const auto anew = receivers.compute(emitter, which);
    if (!anew) return nullptr;
    values.resize(receivers.count * receivers.figures);
    for (std::size_t k = 0; k < which.size(); ++k)
        std::copy_n(anew->begin() + static_cast<std::ptrdiff_t>(k * receivers.figures), receivers.figures,
                    values.begin() + static_cast<std::ptrdiff_t>(which[k] * receivers.figures));
    kept = {std::move(light),   photometry ? std::optional(*photometry) : std::nullopt,
            receivers.identity, receivers.accuracy,
            occluders,          std::make_shared<const std::vector<double>>(std::move(values))};
    return kept.values;
}

std::optional<std::vector<double>> DirectStage::sum(const Scene& scene, const LightReceivers& receivers,
                                                    const std::shared_ptr<const OccluderSet>& occluders) {
    start();
    std::vector<double> total(receivers.count * receivers.figures, 0.0);
    for (const Luminaire& luminaire : scene.luminaires) {
        const double share = output_share(scene, luminaire);
        if (share <= 0.0) continue;
        const Values values = of(scene, luminaire, receivers, occluders);
        if (!values) return std::nullopt;
        for (std::size_t k = 0; k < total.size(); ++k) total[k] += share * (*values)[k];
    }
    forget_others(scene);
    return total;
}

void DirectStage::forget_others(const Scene& scene) {
    std::erase_if(entries_, [&](const auto& entry) {
        return std::none_of(scene.luminaires.begin(), scene.luminaires.end(),
                            [&](const Luminaire& luminaire) { return luminaire.id == entry.first; });
    });
}

}  // namespace hanei
