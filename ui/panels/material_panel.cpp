#include "engine/edit/material_palette.h"
#include "engine/edit/reflectances.h"
#include "engine/scene/colour.h"
#include "ui/panels/edited_object.h"
#include "ui/panels/properties.h"
#include "ui/panels/property_rows.h"

#include <algorithm>
#include <fmt/format.h>

namespace hanei {

namespace {

/// Takes name, reflectance and, where it had a colour, colour of a usual material.
bool palette_row(Material& material, Form& form) {
    std::vector<std::string> names;
    std::vector<ImU32> marks;
    int chosen = -1;
    for (const PaletteEntry& entry : material_palette()) {
        const Material usual = material_of(entry, true);
        if (material.name == entry.name) chosen = static_cast<int>(names.size());
        names.push_back(fmt::format("{} ({:.0f} %)", entry.name, 100.0 * entry.reflectance));
        marks.push_back(mark_of(usual));
    }
    if (!form.choice("material.palette", "Palette", "A usual material, without its colour", names, chosen, marks))
        return false;
    const PaletteEntry& entry = material_palette()[static_cast<std::size_t>(chosen)];
    material.name = entry.name;
    material.reflectance = entry.reflectance;
    material.tint = Vec3(1.0);
    return true;
}

bool usual_colour_row(Material& material, Form& form) {
    const PaletteEntry* const entry = find_in_palette(material.name);
    if (entry == nullptr || material.tint != Vec3(1.0)) return false;
    const Vec3 tint = tint_from_srgb(entry->srgb, material.reflectance);
    if (tint == Vec3(1.0)) return false;
    if (!form.button("material.usual_colour", "Usual colour",
                     "The colour that it mostly has; a room with colours takes longer to work out"))
        return false;
    material.tint = tint;
    return true;
}

/// What it covers, and changes to that.
std::optional<Scene> use_rows(const Scene& scene, ObjectId id, Form& form) {
    const int users = users_of_material(scene, id);
    form.heading("Use");
    form.fact("Covers", users == 1 ? "1 face or part" : fmt::format("{} faces and parts", users));
    if (users == 0) {
        if (!form.button("material.delete", "Delete", "Takes it out of the project: nothing is covered with it"))
            return std::nullopt;
        Scene wished = scene;
        std::erase_if(wished.materials, [&](const Material& material) { return material.id == id; });
        return wished;
    }
    ObjectId other;
    if (!material_row("material.replace", "Replace by", scene, other, form)) return std::nullopt;
    return with_material_replaced(scene, id, other);
}

std::optional<Scene> colour_rows(const Scene& scene, ObjectId id, Form& form) {
    return edited(scene, &Scene::materials, id, [&](Material& material) {
        bool changed = form.text("material.name", "Name", "What this material is called", material.name);
        changed |= palette_row(material, form);
        // No band reflects more than paint can: the deeper a colour, the darker its surface.
        const double greatest = std::max({material.tint.x, material.tint.y, material.tint.z});
        const double lightest = material.tint == Vec3(1.0) ? 1.0 : most_of_a_chosen_band / greatest;
        changed |= percent_row(
            {"material.reflectance", "Reflectance", "%",
             "Share of the arriving luminous flux of neutral light that leaves again", 0.0, 100.0 * lightest, 0.2, 1},
            material.reflectance, form);
        Vec3 shown = srgb_from(material);
        if (form.colour("material.colour", "Colour",
                        "Hue and saturation beside white paper; how light it is follows from the reflectance", shown)) {
            material.tint = tint_from_srgb(shown, material.reflectance);
            changed = true;
        }
        changed |= usual_colour_row(material, form);
        if (material.tint == Vec3(1.0)) return changed;
        if (form.button("material.neutral", "Neutral", "Without colour, of the same reflectance")) {
            material.tint = Vec3(1.0);
            changed = true;
        }
        constexpr double nearly = 0.999;
        if (material.reflectance > nearly * lightest)
            form.remark("This colour can be no lighter: choose a paler one, or a lower reflectance for a deeper one.",
                        false);
        return changed;
    });
}

}  // namespace

std::optional<Scene> material_panel(const Scene& scene, ObjectId id, Form& form) {
    std::optional<Scene> wished = colour_rows(scene, id, form);
    std::optional<Scene> used = use_rows(scene, id, form);
    return used ? std::move(used) : std::move(wished);
}

}  // namespace hanei
