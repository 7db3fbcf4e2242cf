/// Reflectances of the room's ceiling, walls and floor, and of materials everywhere.
#pragma once

#include "engine/scene/scene.h"

#include <optional>
#include <span>
#include <string_view>

namespace hanei {

/// Of a room to be planned before its colours are known, 0 to 1.
struct Reflectances {
    double ceiling = 0.7, walls = 0.5, floor = 0.2;
    bool operator==(const Reflectances&) const = default;
};

struct ReflectancePreset {
    std::string_view name;  ///< "70/50/20", ceiling first
    std::string_view help;
    Reflectances values;
};

/// The sets that utilisation tables and lighting programs share. EN 12464-1 wants ceilings of 0.7 to
/// 0.9, walls of 0.5 to 0.8 and floors of 0.2 to 0.6.
std::span<const ReflectancePreset> reflectance_presets();

/// Three percentages as in "70/50/20".
///
/// Returns   nothing when the text is none, or a percentage lies outside 0 to 100.
std::optional<Reflectances> reflectances_of(std::string_view text);

/// The room's surfaces with these reflectances: the materials of ceiling, walls and floor are changed
/// where only that surface uses them, else replaced by one of its own. Sub-areas and furniture stay.
Scene with_reflectances(Scene scene, const Reflectances& reflectances);

/// Of the room's ceiling, walls (their mean by length) and floor. Nothing without a room.
std::optional<Reflectances> reflectances_of(const Scene& scene);

/// How many room faces, sub-areas, parts of furniture and surfaces a material covers.
int users_of_material(const Scene& scene, ObjectId material);

/// `other` wherever `material` was; `material` stays in the list, unused.
Scene with_material_replaced(Scene scene, ObjectId material, ObjectId other);

/// Without the materials that cover nothing.
Scene without_unused_materials(Scene scene);

}  // namespace hanei
