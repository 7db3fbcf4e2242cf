/// Usual materials of rooms by name.
///
/// Reflectances are round figures within the ranges that lighting handbooks print after DIN 5036-3
/// and CIE guidance (white paint 0.75 to 0.85, birch and maple 0.5 to 0.6, light oak 0.25 to 0.35,
/// walnut 0.15 to 0.2, raw concrete 0.1 to 0.5, clear glass 0.06 to 0.1), greys the luminous
/// reflectance Y of the RAL colour they are named after. For a calculation that counts, measure.
#pragma once

#include "engine/scene/scene.h"

#include <span>
#include <string_view>

namespace hanei {

struct PaletteEntry {
    std::string_view name;
    std::string_view group;  ///< "Paint", "Wood", ...
    double reflectance;
    Vec3 srgb;  ///< hue and saturation of its usual colour beside white paper; grey: none
};

std::span<const PaletteEntry> material_palette();
/// Null when the palette has none of this name.
const PaletteEntry* find_in_palette(std::string_view name);

/// Of this entry. `coloured` gives it its usual tint: a scene with any tint is worked out in three bands.
Material material_of(const PaletteEntry& entry, bool coloured = false);

/// The scene's own material of this name, added from the palette (or as a grey of one half) when there is none.
ObjectId material_named(Scene& scene, std::string_view name);

}  // namespace hanei
