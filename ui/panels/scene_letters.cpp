#include "ui/panels/scene_letters.h"

#include "ui/panels/fonts.h"

namespace hanei {

void need_letters_of(const Scene& scene) {
    const auto names_of = [](const auto& list) {
        for (const auto& each : list) style::needs(each.name);
    };
    style::needs(scene.title);
    if (scene.room) style::needs(scene.room->name);
    names_of(scene.furniture);
    names_of(scene.surfaces);
    names_of(scene.materials);
    names_of(scene.luminaires);
    names_of(scene.grids);
    names_of(scene.points);
    names_of(scene.views);
    names_of(scene.control_groups);
    names_of(scene.light_scenes);
    names_of(scene.arrangements);
    names_of(scene.object_groups);
    for (const Photometry& photometry : scene.photometries) {
        style::needs(photometry.name);
        style::needs(photometry.source_file);
        for (const auto& [key, text] : photometry.keywords) style::needs(text);
    }
}

}  // namespace hanei
