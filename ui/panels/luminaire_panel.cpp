#include "engine/edit/control_groups.h"
#include "engine/edit/luminaire_edits.h"
#include "engine/scene/colour.h"
#include "ui/panels/holding_rows.h"
#include "ui/panels/photometry_rows.h"
#include "ui/panels/properties.h"
#include "ui/panels/property_rows.h"
#include "ui/panels/style.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>
#include <numbers>

namespace hanei {
namespace {

/// The two half sides of an axis-aligned rectangle about the origin; empty for any other outline.
std::optional<Vec2> rectangle_of(const PolygonOpening& opening) {
    const Polygon& outline = opening.region.outline;
    if (outline.size() != 4 || !opening.region.holes.empty()) return std::nullopt;
    const Vec2 half{std::abs(outline[0].x), std::abs(outline[0].y)};
    for (const Vec3& corner : outline) {
        if (std::abs(corner.x) != half.x || std::abs(corner.y) != half.y || corner.z != outline[0].z)
            return std::nullopt;
    }
    return half;
}

bool opening_rows(Luminaire& luminaire, Form& form) {
    bool changed = false;
    if (auto* line = std::get_if<LineOpening>(&luminaire.opening)) {
        double length = glm::length(line->to - line->from);
        if (form.number({"luminaire.length", "Length", "m", "Length of the luminous line", 0.01, 100.0, 0.01, 3},
                        length)) {
            const Vec3 middle = 0.5 * (line->from + line->to);
            const Vec3 half = 0.5 * length * glm::normalize(line->to - line->from);
            *line = {middle - half, middle + half};
            changed = true;
        }
    }
    auto* area = std::get_if<PolygonOpening>(&luminaire.opening);
    const std::optional<Vec2> half = area != nullptr ? rectangle_of(*area) : std::nullopt;
    if (!half) return changed;
    Vec2 size = 2.0 * *half;
    changed |= form.number({"luminaire.width", "Width", "m", "Luminous opening along its own x", 0.01, 100.0, 0.01, 3},
                           size.x);
    changed |= form.number({"luminaire.depth", "Depth", "m", "Luminous opening along its own y", 0.01, 100.0, 0.01, 3},
                           size.y);
    for (Vec3& corner : area->region.outline) {
        corner.x = std::copysign(0.5 * size.x, corner.x);
        corner.y = std::copysign(0.5 * size.y, corner.y);
    }
    return changed;
}

bool output_rows(Luminaire& luminaire, const Photometry* photometry, Form& form) {
    bool changed = false;
    if (photometry != nullptr) {
        changed |= flux_rows(luminaire, *photometry, form);
    } else if (auto* flux = std::get_if<LuminousFlux>(&luminaire.output)) {
        changed |=
            form.number({"luminaire.flux", "Luminous flux", "lm", "Of the luminaire at full output", 0.0, 1e7, 10.0, 0},
                        flux->value);
    }
    if (auto* luminance = std::get_if<Luminance>(&luminaire.output)) {
        changed |= form.number(
            {"luminaire.luminance", "Luminance", "cd/m²", "Of the opening at full output", 0.0, 1e9, 10.0, 0},
            luminance->value);
    }
    if (auto* power = std::get_if<CosinePower>(&luminaire.distribution)) {
        changed |= form.number(
            {"luminaire.exponent", "Beam exponent", "",
             "Intensity falls with this power of the cosine from the axis: 1 is wide, 50 a spot", 0.0, 1000.0, 0.1, 1},
            power->exponent);
    }
    double percent = 100.0 * luminaire.dimming;
    if (form.number({"luminaire.dimming", "Dimmer", "%", "Share of the full output, times the dimmer of its group", 0.0,
                     100.0, 0.5, 1},
                    percent)) {
        luminaire.dimming = percent / 100.0;
        changed = true;
    }
    return changed;
}

bool colour_rows(const Scene& scene, Luminaire& luminaire, Form& form) {
    if (const ControlGroup* group = find_control_group(scene, luminaire.group);
        group && group->colour_temperature > 0.0) {
        form.fact("Light colour", fmt::format("{:.0f}", group->colour_temperature), "K");
        form.remark("As its group has it.", false);
        return false;
    }
    const bool changed =
        light_colour_rows({"luminaire.colour", "luminaire.temperature", "Neutral"}, luminaire.colour_temperature, form);
    if (luminaire.colour_temperature > 0.0 && is_light_of_one_colour(scene))
        form.remark("All light has this colour: eyes and pictures take it for white.", false);
    return changed;
}

/// True when pressed: all luminaires shall have the light colour of this one.
bool is_colour_for_all(const Scene& scene, const Luminaire& luminaire, Form& form) {
    const bool alike = std::all_of(scene.luminaires.begin(), scene.luminaires.end(), [&](const Luminaire& other) {
        return other.colour_temperature == luminaire.colour_temperature;
    });
    return !alike &&
           form.button("luminaire.colour_all", "Same for all luminaires", "Gives every luminaire this light colour");
}

bool distribution_row(Luminaire& luminaire, Form& form) {
    if (!std::holds_alternative<PointOpening>(luminaire.opening)) return false;
    const std::array<std::string, 2> names{"Even all around", "Downward beam"};
    int chosen = std::holds_alternative<CosinePower>(luminaire.distribution) ? 1 : 0;
    if (std::holds_alternative<Measured>(luminaire.distribution)) return false;
    if (!form.choice("luminaire.distribution", "Distribution", "How intensity depends on direction", names, chosen))
        return false;
    if (chosen == 1)
        luminaire.distribution = CosinePower{2.0};
    else
        luminaire.distribution = Diffuse{};
    return true;
}

const char* opening_name(const Opening& opening) {
    constexpr std::array names{"Point", "Line", "Luminous area", "Luminous solid", "As its file says"};
    return names[opening.index()];
}

}  // namespace

std::optional<Scene> luminaire_panel(const Scene& scene, ObjectId id, Form& form) {
    const auto found = std::find_if(scene.luminaires.begin(), scene.luminaires.end(),
                                    [&](const Luminaire& luminaire) { return luminaire.id == id; });
    if (found == scene.luminaires.end()) return std::nullopt;
    Luminaire luminaire = *found;
    bool changed = form.text("luminaire.name", "Name", "What this luminaire is called", luminaire.name);
    const ControlGroup* const group = find_control_group(scene, luminaire.group);
    std::string group_name = group != nullptr ? group->name : std::string();
    const bool regrouped =
        form.text("luminaire.group", "Group", "Luminaires of one group are dimmed together", group_name);
    changed |= regrouped;
    form.heading("Light");
    form.fact("Opening", std::string(tr(opening_name(luminaire.opening))));
    changed |= opening_rows(luminaire, form);
    changed |= distribution_row(luminaire, form);
    changed |= output_rows(luminaire, photometry_of(scene, *found), form);
    changed |= colour_rows(scene, luminaire, form);
    const bool colour_for_all = is_colour_for_all(scene, *found, form);
    changed |= colour_for_all;
    const ObjectId own[] = {id};
    std::optional<Scene> held;
    form.heading("Place");
    changed |= place_rows("luminaire", luminaire.position, form);
    held = mounting_rows(scene, own, form);
    form.heading("Direction");
    changed |= angle_row(
        {"luminaire.yaw", "Turn", "°", "About the vertical, counter-clockwise from above", -360.0, 360.0, 0.5, 1},
        luminaire.yaw, form);
    if (form.button("luminaire.turn", "Turn by 90°",
                    "Housing and light together, about the vertical, counter-clockwise from above  (T)")) {
        luminaire.yaw = turned_by_a_quarter(luminaire.yaw);
        changed = true;
    }
    changed |= angle_row({"luminaire.tilt", "Tilt", "°", "Turns the light towards plane C0", -180.0, 180.0, 0.5, 1},
                         luminaire.tilt, form);
    changed |= angle_row({"luminaire.roll", "Roll", "°", "About the luminaire's own x axis", -180.0, 180.0, 0.5, 1},
                         luminaire.roll, form);
    form.heading("Shines at");
    if (auto aimed_so = aim_rows(scene, own, form)) held = std::move(aimed_so);
    changed |=
        form.toggle("luminaire.opaque", "Hides things", "The opening hides what lies behind it", luminaire.opaque);
    if (held) return held;
    if (!changed) return std::nullopt;
    Scene wished = scene;
    if (regrouped) luminaire.group = control_group_named(wished, group_name);
    for (Luminaire& other : wished.luminaires) {
        if (other.id == id) other = luminaire;
        if (colour_for_all) other.colour_temperature = luminaire.colour_temperature;
    }
    return wished;
}

}  // namespace hanei
