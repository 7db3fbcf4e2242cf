#include "engine/study/stage_keys.h"

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
    return kept;
}

Scene shapes_of(const Scene& scene) {
    Scene kept = surfaces_of(scene);
    if (kept.room) {
        kept.room->floor_material = kept.room->ceiling_material = {};
        for (ObjectId& material : kept.room->wall_materials) material = {};
        for (SubArea& area : kept.room->sub_areas) area.material = {};
    }
    for (Furniture& furniture : kept.furniture) {
        for (Part& part : furniture.parts) part.material = {};
    }
    for (FreeSurface& surface : kept.surfaces) {
        surface.material = {};
        surface.own_exitance = {};
    }
    return kept;
}

Luminaire light_of(const Luminaire& luminaire) {
    Luminaire kept = luminaire;
    kept.name.clear();
    kept.group.clear();
    kept.unknown.clear();
    kept.dimming = 1.0;
    return kept;
}

}  // namespace hanei
