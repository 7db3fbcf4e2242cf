#include "engine/study/direct_stage.h"

#include "engine/study/stage_keys.h"

#include <algorithm>

namespace hanei {

namespace {

std::optional<Photometry> photometry_of(const Scene& scene, const Luminaire& luminaire) {
    const auto* measured = std::get_if<Measured>(&luminaire.distribution);
    if (!measured) return std::nullopt;
    for (const Photometry& photometry : scene.photometries) {
        if (photometry.id == measured->photometry) return photometry;
    }
    return std::nullopt;
}

}  // namespace

double output_share(const Scene& scene, const Luminaire& luminaire) {
    return luminaire.dimming * scene.maintenance_factor;
}

std::optional<std::vector<double>> DirectStage::sum(const Scene& scene, std::size_t count,
                                                    const std::shared_ptr<const void>& receivers,
                                                    const std::shared_ptr<const OccluderSet>& occluders,
                                                    const Compute& compute) {
    reused_ = true;
    std::vector<double> total(count, 0.0);
    for (const Luminaire& luminaire : scene.luminaires) {
        Entry wanted{light_of(luminaire), photometry_of(scene, luminaire), receivers, occluders, {}};
        Entry& kept = entries_[luminaire.id];
        const bool same = kept.values.size() == count && kept.light == wanted.light &&
                          kept.photometry == wanted.photometry && kept.receivers == wanted.receivers &&
                          kept.occluders == wanted.occluders;
        if (!same) {
            reused_ = false;
            auto values = compute(Emitter(scene, luminaire));
            if (!values) return std::nullopt;
            kept = std::move(wanted);
            kept.values = std::move(*values);
        }
        const double share = output_share(scene, luminaire);
        for (std::size_t k = 0; k < count; ++k) total[k] += share * kept.values[k];
    }
    std::erase_if(entries_, [&](const auto& entry) {
        return std::none_of(scene.luminaires.begin(), scene.luminaires.end(),
                            [&](const Luminaire& luminaire) { return luminaire.id == entry.first; });
    });
    return total;
}

}  // namespace hanei
