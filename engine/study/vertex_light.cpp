#include "engine/study/vertex_light.h"

#include "engine/scene/colour.h"
#include "engine/study/direct_stage.h"
#include "engine/study/stage_keys.h"

#include <algorithm>
#include <array>

namespace hanei {

namespace {

constexpr float unknown = -1.0F;
constexpr std::size_t block = 64;  // places made one after the other lie close together

std::array<Vec3, 8> box_around(std::span<const Receiver> places) {
    Vec3 low = places.front().position, high = low;
    for (const Receiver& place : places) {
        low = glm::min(low, place.position);
        high = glm::max(high, place.position);
    }
    std::array<Vec3, 8> corners;
    for (std::size_t c = 0; c < 8; ++c)
        corners[c] = {(c & 1U) != 0 ? high.x : low.x, (c & 2U) != 0 ? high.y : low.y, (c & 4U) != 0 ? high.z : low.z};
    return corners;
}

/// Whether a body that went or came may stand between.
bool is_touched(std::span<const Vec3> places, const Emitter& emitter, const BodyChanges& changes,
                std::vector<BodyIndex>& between) {
    between.clear();
    changes.gone.between(places, emitter.extent(), between);
    if (between.empty()) changes.come.between(places, emitter.extent(), between);
    return !between.empty();
}

}  // namespace

/// Light that is known from before the bodies moved, where that may have changed it.
void VertexLight::forget_shadowed(Kept& kept, std::span<const Receiver> places) {
    if (kept.occluders == occluders_) return;
    const BodyChanges* const changes =
        kept.occluders && occluders_ ? &changes_.between(kept.occluders, occluders_) : nullptr;
    kept.occluders = occluders_;
    if (!changes || changes->most) return kept.lux.clear();
    std::vector<BodyIndex> between;
    const std::size_t count = std::min(kept.lux.size(), places.size());
    for (std::size_t first = 0; first < count; first += block) {
        const auto here = places.subspan(first, std::min(block, count - first));
        if (!is_touched(box_around(here), *kept.emitter, *changes, between)) continue;
        for (std::size_t k = first; k < first + here.size(); ++k)
            if (is_touched(std::span(&places[k].position, 1), *kept.emitter, *changes, between)) kept.lux[k] = unknown;
    }
}

bool VertexLight::follow(const Scene& scene, const std::shared_ptr<const OccluderSet>& occluders,
                         const Accuracy& accuracy, std::span<const Receiver> places) {
    if (!(accuracy == accuracy_)) clear();
    bool changed = accuracy != accuracy_ || occluders != occluders_;
    accuracy_ = accuracy;
    occluders_ = occluders;
    worked_ = false;

    std::vector<Shining> shining;
    for (const Luminaire& luminaire : scene.luminaires) {
        const double share = output_share(scene, luminaire);
        if (share <= 0.0) continue;
        Kept& kept = kept_[luminaire.id];
        Luminaire light = light_of(luminaire);
        const Photometry* const measured = measured_of(scene, luminaire);
        const bool same =
            kept.emitter && kept.light == light && (measured ? kept.photometry == *measured : !kept.photometry);
        if (same) {
            forget_shadowed(kept, places);
        } else {
            kept = {std::move(light),
                    measured ? std::optional(*measured) : std::nullopt,
                    Emitter(scene, luminaire),
                    occluders,
                    {}};
            changed = true;
        }
        shining.push_back({&kept, share, band_output(luminaire, scene)});
    }
    const auto weighed_alike = [](const Shining& a, const Shining& b) {
        return a.kept == b.kept && a.share == b.share && a.bands == b.bands;
    };
    changed = changed || !std::equal(shining.begin(), shining.end(), shining_.begin(), shining_.end(), weighed_alike);
    shining_ = std::move(shining);
    std::erase_if(kept_, [&](const auto& entry) {
        return std::none_of(scene.luminaires.begin(), scene.luminaires.end(),
                            [&](const Luminaire& luminaire) { return luminaire.id == entry.first; });
    });
    return changed;
}

bool VertexLight::light(std::span<const Receiver> places, std::span<const std::uint32_t> which, const Work& work) {
    std::vector<std::uint32_t> dark;
    std::vector<Receiver> receivers;
    for (const Shining& shining : shining_) {
        std::vector<float>& lux = shining.kept->lux;
        lux.resize(places.size(), unknown);
        dark.clear();
        receivers.clear();
        for (const std::uint32_t k : which) {
            if (lux[k] >= 0.0F) continue;
            dark.push_back(k);
            receivers.push_back(places[k]);
        }
        if (dark.empty()) continue;
        worked_ = true;
        const auto lit = direct_estimates(*shining.kept->emitter, receivers, occluders_.get(), accuracy_, work);
        if (!lit) return false;
        for (std::size_t k = 0; k < dark.size(); ++k) lux[dark[k]] = static_cast<float>((*lit)[k]);
    }
    return true;
}

void VertexLight::forget(std::uint32_t place) {
    for (auto& [id, kept] : kept_)
        if (place < kept.lux.size()) kept.lux[place] = unknown;
}

void VertexLight::clear() {
    for (auto& [id, kept] : kept_) kept.lux.clear();
}

double VertexLight::total(std::uint32_t place) const {
    double sum = 0.0;
    for (const Shining& shining : shining_) sum += shining.share * static_cast<double>(shining.kept->lux[place]);
    return sum;
}

Vec3 VertexLight::bands(std::uint32_t place) const {
    Vec3 sum(0.0);
    for (const Shining& shining : shining_)
        sum += shining.share * static_cast<double>(shining.kept->lux[place]) * shining.bands;
    return sum;
}

double VertexLight::flux() const {
    double flux = 0.0;
    for (const Shining& shining : shining_) flux += shining.share * shining.kept->emitter->flux().value;
    return flux;
}

}  // namespace hanei
