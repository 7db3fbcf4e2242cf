#include "engine/study/vertex_light.h"

#include "engine/scene/colour.h"
#include "engine/study/direct_stage.h"
#include "engine/study/stage_keys.h"

#include <algorithm>
#include <array>
#include <limits>

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
    if (!changes || changes->most) {
        kept.lux.clear();
        kept.guessed.clear();
        return;
    }
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
                    {},
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

bool VertexLight::light_those(Kept& kept, std::span<const Receiver> places, std::span<const std::uint32_t> dark,
                              const Work& work) {
    if (dark.empty()) return true;
    worked_ = true;
    std::vector<Receiver> receivers;
    receivers.reserve(dark.size());
    for (const std::uint32_t k : dark) receivers.push_back(places[k]);
    const auto lit = direct_estimates(*kept.emitter, receivers, occluders_.get(), accuracy_, work);
    if (!lit) return false;
    for (std::size_t k = 0; k < dark.size(); ++k) kept.lux[dark[k]] = static_cast<float>((*lit)[k]);
    return true;
}

bool VertexLight::light(std::span<const Receiver> places, std::span<const std::uint32_t> which, const Work& work) {
    std::vector<std::uint32_t> dark;
    for (const Shining& shining : shining_) {
        Kept& kept = *shining.kept;
        kept.lux.resize(places.size(), unknown);
        for (const std::uint32_t k : kept.guessed) kept.lux[k] = unknown;
        kept.guessed.clear();
        dark.clear();
        for (const std::uint32_t k : which)
            if (kept.lux[k] < 0.0F) dark.push_back(k);
        if (!light_those(kept, places, dark, work)) return false;
    }
    return !work.stop.stop_requested();
}

/// From the corners of the vertex's cell; where they differ too much, it is one of the dark.
void VertexLight::guess(const Shining& shining, const DisplayCut& cut, std::size_t vertex,
                        std::vector<std::uint32_t>& dark) const {
    std::vector<float>& lux = shining.kept->lux;
    const DisplayParents& parents = cut.parents[vertex];
    float low = std::numeric_limits<float>::infinity(), high = 0.0F, darkest = low, middle = 0.0F;
    for (std::size_t c = 0; c < 4; ++c) {
        const float here = lux[cut.places[parents.cell[c]]];
        low = std::min(low, here);
        high = std::max(high, here);
        darkest = std::min(darkest, cut.direct[parents.cell[c]]);
        middle += 0.25F * lux[cut.places[parents.between[c]]];
    }
    const std::uint32_t place = cut.places[vertex];
    if (is_noticeable(static_cast<float>(shining.share) * (high - low), darkest, cut.brightest)) {
        dark.push_back(place);
    } else {
        lux[place] = middle;
        shining.kept->guessed.push_back(place);
    }
}

bool VertexLight::light_roughly(std::span<const Receiver> places, const DisplayCut& cut, const Work& work) {
    constexpr std::size_t lit_rounds = 2;  // a shadow inside a patch may leave all its corners lit
    std::vector<std::uint32_t> dark;
    for (const Shining& shining : shining_) {
        shining.kept->lux.resize(places.size(), unknown);
        std::size_t vertex = 0;
        for (std::size_t round = 0; round < cut.rounds.size(); ++round) {
            dark.clear();
            for (; vertex < cut.rounds[round]; ++vertex) {
                const std::uint32_t place = cut.places[vertex];
                if (shining.kept->lux[place] >= 0.0F) continue;
                if (round < lit_rounds) {
                    dark.push_back(place);
                } else {
                    guess(shining, cut, vertex, dark);
                }
            }
            if (!light_those(*shining.kept, places, dark, work)) return false;
        }
    }
    return true;
}

void VertexLight::forget(std::uint32_t place) {
    for (auto& [id, kept] : kept_)
        if (place < kept.lux.size()) kept.lux[place] = unknown;
}

void VertexLight::clear() {
    for (auto& [id, kept] : kept_) {
        kept.lux.clear();
        kept.guessed.clear();
    }
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
