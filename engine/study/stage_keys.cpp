#include "engine/study/stage_keys.h"

#include <algorithm>

namespace hanei {

Scene surfaces_of(const Scene& scene) {
    Scene kept;
    kept.room = scene.room;
    kept.furniture = scene.furniture;
    kept.surfaces = scene.surfaces;
    const auto forget_words = [](auto& object) {
        object.name.clear();
        object.unknown.clear();
    };
    if (kept.room) {
        forget_words(*kept.room);
        for (SubArea& area : kept.room->sub_areas) forget_words(area);
    }
    for (Furniture& furniture : kept.furniture) {
        forget_words(furniture);
        for (Part& part : furniture.parts) part.unknown.clear();
    }
    for (FreeSurface& surface : kept.surfaces) forget_words(surface);
    for (const Luminaire& luminaire : scene.luminaires) {
        if (!luminaire.opaque) continue;
        kept.luminaires.push_back(light_of(luminaire));
        kept.luminaires.back().output = LuminousFlux{};
    }
    kept.photometries = kept.luminaires.empty() ? std::vector<Photometry>{} : scene.photometries;
    return kept;
}

Luminaire light_of(const Luminaire& luminaire) {
    Luminaire kept = luminaire;
    kept.name.clear();
    kept.group = {};
    kept.unknown.clear();
    kept.dimming = 1.0;
    kept.colour_temperature = 0.0;
    return kept;
}

const Photometry* measured_of(const Scene& scene, const Luminaire& luminaire) {
    const auto* measured = std::get_if<Measured>(&luminaire.distribution);
    if (!measured) return nullptr;
    const auto found =
        std::find_if(scene.photometries.begin(), scene.photometries.end(),
                     [&](const Photometry& photometry) { return photometry.id == measured->photometry; });
    return found == scene.photometries.end() ? nullptr : &*found;
}

}  // namespace hanei
