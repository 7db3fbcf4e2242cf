#include "engine/edit/material_palette.h"

#include "engine/scene/colour.h"

#include <algorithm>
#include <array>

namespace hanei {
namespace {

constexpr Vec3 grey{0.5};

constexpr std::array palette{
    PaletteEntry{"White paint", "Paint", 0.80, {1.0, 0.99, 0.96}},
    PaletteEntry{"Pure white (RAL 9010)", "Paint", 0.85, {0.98, 0.97, 0.93}},
    PaletteEntry{"Traffic white (RAL 9016)", "Paint", 0.87, grey},
    PaletteEntry{"Cream (RAL 9001)", "Paint", 0.75, {0.94, 0.90, 0.79}},
    PaletteEntry{"Grey white (RAL 9002)", "Paint", 0.66, {0.87, 0.86, 0.80}},
    PaletteEntry{"Light grey (RAL 7035)", "Paint", 0.58, {0.80, 0.82, 0.81}},
    PaletteEntry{"Signal grey (RAL 7004)", "Paint", 0.33, grey},
    PaletteEntry{"Dusty grey (RAL 7037)", "Paint", 0.20, grey},
    PaletteEntry{"Anthracite (RAL 7016)", "Paint", 0.08, {0.22, 0.25, 0.28}},
    PaletteEntry{"Black (RAL 9005)", "Paint", 0.04, grey},
    PaletteEntry{"Yellow paint", "Paint", 0.55, {0.96, 0.80, 0.35}},
    PaletteEntry{"Green paint", "Paint", 0.35, {0.55, 0.75, 0.52}},
    PaletteEntry{"Blue paint", "Paint", 0.20, {0.35, 0.52, 0.78}},
    PaletteEntry{"Red paint", "Paint", 0.15, {0.75, 0.25, 0.20}},
    PaletteEntry{"Wood, light", "Wood", 0.50, {0.90, 0.76, 0.58}},
    PaletteEntry{"Wood, medium", "Wood", 0.30, {0.74, 0.55, 0.36}},
    PaletteEntry{"Wood, dark", "Wood", 0.15, {0.50, 0.34, 0.22}},
    PaletteEntry{"White laminate", "Furniture", 0.75, grey},
    PaletteEntry{"Grey laminate", "Furniture", 0.45, grey},
    PaletteEntry{"Dark plastic", "Furniture", 0.10, grey},
    PaletteEntry{"Black screen", "Furniture", 0.05, grey},
    PaletteEntry{"Steel, grey", "Furniture", 0.40, grey},
    PaletteEntry{"Fabric, light", "Furniture", 0.50, {0.88, 0.84, 0.76}},
    PaletteEntry{"Fabric, grey", "Furniture", 0.30, grey},
    PaletteEntry{"Fabric, dark", "Furniture", 0.12, {0.28, 0.32, 0.42}},
    PaletteEntry{"Bed linen", "Furniture", 0.75, {0.97, 0.96, 0.93}},
    PaletteEntry{"Books and paper", "Furniture", 0.40, {0.72, 0.62, 0.52}},
    PaletteEntry{"Cardboard", "Furniture", 0.35, {0.76, 0.60, 0.42}},
    PaletteEntry{"Leaves", "Furniture", 0.15, {0.36, 0.52, 0.26}},
    PaletteEntry{"Skin", "Furniture", 0.35, {0.86, 0.67, 0.55}},
    PaletteEntry{"Window pane by night", "Openings", 0.10, grey},
    PaletteEntry{"Curtain", "Openings", 0.55, {0.90, 0.87, 0.80}},
    PaletteEntry{"Door", "Openings", 0.50, {0.88, 0.80, 0.68}},
    PaletteEntry{"Whiteboard", "Openings", 0.80, grey},
    PaletteEntry{"Chalkboard", "Openings", 0.08, {0.20, 0.33, 0.27}},
    PaletteEntry{"Pinboard", "Openings", 0.30, {0.72, 0.56, 0.40}},
    PaletteEntry{"Picture", "Openings", 0.35, {0.60, 0.62, 0.66}},
    PaletteEntry{"Plaster", "Building", 0.80, {0.97, 0.95, 0.90}},
    PaletteEntry{"Concrete", "Building", 0.30, {0.68, 0.66, 0.63}},
    PaletteEntry{"Red brick", "Building", 0.15, {0.67, 0.36, 0.27}},
    PaletteEntry{"Acoustic ceiling", "Building", 0.70, grey},
    PaletteEntry{"Carpet, light", "Floor", 0.30, {0.74, 0.70, 0.64}},
    PaletteEntry{"Carpet, dark", "Floor", 0.10, {0.30, 0.33, 0.40}},
    PaletteEntry{"Linoleum", "Floor", 0.25, {0.62, 0.58, 0.50}},
    PaletteEntry{"Parquet", "Floor", 0.30, {0.74, 0.56, 0.38}},
    PaletteEntry{"Tiles, light", "Floor", 0.55, {0.92, 0.90, 0.86}},
    PaletteEntry{"Screed", "Floor", 0.25, grey},
};

}  // namespace

std::span<const PaletteEntry> material_palette() { return palette; }

const PaletteEntry* find_in_palette(std::string_view name) {
    const auto found =
        std::find_if(palette.begin(), palette.end(), [&](const PaletteEntry& entry) { return entry.name == name; });
    return found == palette.end() ? nullptr : &*found;
}

Material material_of(const PaletteEntry& entry, bool coloured) {
    Material material;
    material.name = entry.name;
    material.reflectance = entry.reflectance;
    if (coloured) material.tint = tint_from_srgb(entry.srgb, entry.reflectance);
    return material;
}

ObjectId material_named(Scene& scene, std::string_view name) {
    for (const Material& present : scene.materials)
        if (present.name == name) return present.id;
    Material material;
    material.name = name;
    if (const PaletteEntry* entry = find_in_palette(name)) material = material_of(*entry);
    material.id = scene.new_id();
    scene.materials.push_back(std::move(material));
    return scene.materials.back().id;
}

}  // namespace hanei
