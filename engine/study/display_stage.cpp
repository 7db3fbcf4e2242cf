#include "engine/study/display_stage.h"

#include "engine/scene/colour.h"
#include "engine/study/direct_stage.h"

#include <algorithm>

namespace hanei {

namespace {

constexpr std::size_t most_places = 200'000;  // of cuts gone by: kept light is memory

/// Far below the most that a float holds, where there is more: the paper's form factors from point to point grow past
/// all bounds in a gap of a micrometre, and what is infinite cannot be drawn.
float shown(double lux) { return static_cast<float>(std::min(lux, 1e30)); }

}  // namespace

std::vector<WeightedEmitter> emitters_of(const Scene& scene) {
    std::vector<WeightedEmitter> emitters;
    emitters.reserve(scene.luminaires.size());
    for (const Luminaire& luminaire : scene.luminaires) {
        const double share = output_share(scene, luminaire);
        if (share > 0.0) emitters.push_back({Emitter(scene, luminaire), share});
    }
    return emitters;
}

std::optional<std::vector<double>> direct_from_all(std::span<const WeightedEmitter> emitters,
                                                   std::span<const Receiver> receivers, const OccluderSet* occluders,
                                                   const Work& work) {
    std::vector<double> total(receivers.size(), 0.0);
    for (const WeightedEmitter& weighted : emitters) {
        const auto part = direct_illuminance(weighted.emitter, receivers, occluders, work);
        if (!part) return std::nullopt;
        for (std::size_t k = 0; k < total.size(); ++k) total[k] += weighted.share * (*part)[k];
    }
    return total;
}

bool DisplayStage::cut(const DisplayInput& input, const Work& work) {
    mesh_ = nullptr;
    if (places_.receivers().size() > most_places) {
        places_.clear();
        light_.clear();
        open_light_.clear();
    }
    CutInput cutting;
    cutting.mesh = input.mesh.get();
    cutting.places = &places_;
    cutting.finest = input.finest;
    cutting.on_new = [&](std::uint32_t place) {
        light_.forget(place);
        open_light_.forget(place);
    };
    cutting.light = [&](std::span<const std::uint32_t> places) -> std::optional<std::vector<float>> {
        if (!light_.light(places_.receivers(), places, work)) return std::nullopt;
        std::vector<float> lux;
        for (const std::uint32_t place : places) lux.push_back(static_cast<float>(light_.total(place)));
        return lux;
    };
    auto made = cut_display(cutting);
    if (!made) return false;
    cut_ = std::move(*made);
    mesh_ = input.mesh;
    return true;
}

bool DisplayStage::update(const DisplayInput& input, const Work& work) {
    const bool changed = light_.follow(*input.scene, input.occluders, input.accuracy, places_.receivers());
    if (input.open) open_light_.follow(*input.scene, nullptr, input.accuracy, places_.receivers());
    open_ = input.open;
    coloured_ = !is_neutral(*input.scene);
    const bool same_mesh = mesh_ == input.mesh;
    is_of_the_light_ = is_of_the_light_ && same_mesh && !changed;
    reused_ = is_of_the_light_ || (input.live && same_mesh);
    if (!reused_) {
        is_of_the_light_ = cut(input, work);
        if (!is_of_the_light_) return false;
    }
    const bool roughly = input.live && !is_of_the_light_;
    if (roughly ? !light_.light_roughly(places_.receivers(), cut_, work)
                : !light_.light(places_.receivers(), cut_.places, work))
        return false;
    if (input.open && !open_light_.light(places_.receivers(), cut_.places, work)) return false;
    reused_ = reused_ && !light_.worked() && !(input.open && open_light_.worked());
    return true;
}

std::shared_ptr<const DisplayMesh> DisplayStage::dressed(const LightOfSurfaces& light) const {
    auto display = std::make_shared<DisplayMesh>();
    display->cells = cut_.cells;
    display->has_unshadowed = open_ && !light.open.empty();
    display->vertices.resize(cut_.places.size());
    if (coloured_) display->tinted.resize(cut_.places.size());
    for (std::size_t k = 0; k < cut_.places.size(); ++k) {
        const DisplaySource& source = cut_.sources[k];
        const auto among = [&](std::span<const double> values) {
            std::array<double, 4> corner{};
            for (std::size_t c = 0; c < 4; ++c) corner[c] = values[static_cast<std::size_t>(source.among[c])];
            return bilinear(corner, source.u, source.v);
        };
        DisplayVertex& vertex = display->vertices[k];
        vertex.position = places_.receivers()[cut_.places[k]].position;
        vertex.direct = shown(light_.total(cut_.places[k]));
        vertex.interreflected = shown(among(light.interreflected));
        if (display->has_unshadowed) vertex.unshadowed = shown(open_light_.total(cut_.places[k]) + among(light.open));
        if (!coloured_) continue;
        const Vec3 direct = light_.bands(cut_.places[k]);
        for (std::size_t band = 0; band < colour_bands; ++band) {
            const double from_surfaces = among(light.bands.empty() ? light.interreflected : light.bands[band]);
            display->tinted[k][band] = shown(direct[static_cast<int>(band)] + from_surfaces);
        }
    }
    return display;
}

}  // namespace hanei
