#include "engine/scene/hard_spots.h"

#include "engine/base/tolerance.h"
#include "engine/geometry/polygon.h"
#include "engine/scene/faces.h"
#include "engine/scene/hard_pairs.h"
#include "engine/scene/opening_shape.h"
#include "engine/scene/placement.h"
#include "engine/scene/scene_findings.h"

#include <algorithm>
#include <cmath>

namespace hanei {
namespace {

constexpr double thin = 1e-3;        // m: what programs set rays off a surface by
constexpr double narrow = 1e-3;      // least width of a polygon, of its length
constexpr double far_away = 1e4;     // distance from the origin, of the scene's size
constexpr double nearly_all = 0.95;  // reflectance
constexpr std::size_t a_great_many = 500;

double width_over_length(const Region& region) {
    const double length = diameter(region.outline);
    return length > 0.0 ? glm::length(vector_area(region.outline)) / (length * length) : 0.0;
}

void look_at_materials(HardSpots& spots) {
    const std::vector<Material>& all = spots.scene.materials;
    if (!all.empty() && std::all_of(all.begin(), all.end(), [](const Material& m) { return m.reflectance <= 0.0; }))
        spots.note_whole("materials",
                         "nothing reflects; shares of interreflected light would be 0 / 0. There is direct light alone "
                         "here; give surfaces a reflectance if they have one");
    for (std::size_t i = 0; i < spots.scene.materials.size(); ++i) {
        const Material& material = spots.scene.materials[i];
        if (material.reflectance < nearly_all) continue;
        if (material.reflectance >= 1.0) {
            spots.note("materials", i, "material", material.name, material.id, "reflectance",
                       "it absorbs nothing; a fixed number of interreflections leaves light out, and in a closed room "
                       "there is no end to them. Light is followed until it is absorbed elsewhere or gets out; lower "
                       "it, no paint is like that");
            continue;
        }
        spots.note("materials", i, "material", material.name, material.id, "reflectance",
                   "it keeps " + figure(100.0 * material.reflectance) + " % of all light, which takes some " +
                       figure(std::ceil(std::log(1e-3) / std::log(material.reflectance))) +
                       " interreflections to fade; a fixed few of them leave most of it out. They are followed until "
                       "the accuracy is reached; lower it if no such paint exists");
    }
}

void look_at_furniture(HardSpots& spots) {
    std::size_t parts = 0;
    for (std::size_t i = 0; i < spots.scene.furniture.size(); ++i) {
        const Furniture& furniture = spots.scene.furniture[i];
        parts += furniture.parts.size();
        for (const Part& part : furniture.parts) {
            const auto* const box = std::get_if<BoxShape>(&part.shape);
            if (box == nullptr) continue;
            const double least = std::min({box->size.x, box->size.y, box->size.z});
            if (least >= thin) continue;
            spots.note("furniture", i, "furniture", furniture.name, furniture.id, "parts",
                       "it is " + figure(1000.0 * least) +
                           " mm thin; rays that are set off a surface by a millimetre start behind it and light leaks. "
                           "Shadows are cut from its very faces here, at any thickness; nothing needs to be done");
            break;
        }
    }
    if (parts >= a_great_many)
        spots.note_whole("furniture", "the scene has " + std::to_string(parts) +
                                          " bodies; sampled shadows of many small ones are noise. What is seen past "
                                          "each is cut exactly, which takes its time; remove what casts no shadow "
                                          "that matters");
}

void look_at_surfaces(HardSpots& spots) {
    for (std::size_t i = 0; i < spots.scene.surfaces.size(); ++i) {
        const FreeSurface& surface = spots.scene.surfaces[i];
        if (width_over_length(surface.region) >= narrow) continue;
        spots.note("surfaces", i, "surface", surface.name, surface.id, "outline",
                   "it is a sliver, a thousand times as long as wide; patches of equal sides would be millions. It is "
                   "one patch wide here and its form factors are closed forms; remove it if it is left over from a "
                   "model");
    }
}

/// The planes of the room: floor, ceiling, walls.
std::vector<Plane> planes_of(const Room& room) {
    const double top = room.floor_height + room.height;
    std::vector<Plane> planes{{{0.0, 0.0, room.floor_height}, {0.0, 0.0, 1.0}}, {{0.0, 0.0, top}, {0.0, 0.0, -1.0}}};
    for (std::size_t k = 0; k < room.plan.size(); ++k) {
        const Vec2 along = room.plan[(k + 1) % room.plan.size()] - room.plan[k];
        planes.push_back({{room.plan[k], 0.0}, glm::normalize(Vec3{-along.y, along.x, 0.0})});
    }
    return planes;
}

void look_at_opening(HardSpots& spots, std::size_t i, const Luminaire& luminaire, const Polygon& outline) {
    const auto about = [&](const std::string& message) {
        spots.note("luminaires", i, "luminaire", luminaire.name, luminaire.id, "opening", message);
    };
    if (width_over_length({outline, {}}) < narrow)
        about(
            "its opening is a sliver, a thousand times as long as wide; formulas that subtract angles lose their "
            "digits on it. The contour formula used here keeps them; make it a line if it is a tube");
    if (spots.scene.room) {
        const bool flush = [&] {
            for (const Plane& plane : planes_of(*spots.scene.room))
                if (std::all_of(outline.begin(), outline.end(),
                                [&](const Vec3& corner) { return std::abs(plane.height(corner)) <= spots.thickness; }))
                    return true;
            return false;
        }();
        if (flush)
            about(
                "it is flush with a face of the room; whether that face sees it would be a matter of rounding. "
                "The face gets no light from it here and does not hide it; nothing needs to be done");
    }
}

/// How far the opening of a file reaches out of the room where its luminaire is inside.
void look_at_measured(HardSpots& spots, std::size_t i, const Luminaire& luminaire) {
    const auto* const measured = std::get_if<Measured>(&luminaire.distribution);
    if (!std::holds_alternative<MeasuredOpening>(luminaire.opening) || measured == nullptr || !spots.scene.room) return;
    const auto table = std::find_if(spots.scene.photometries.begin(), spots.scene.photometries.end(),
                                    [&](const Photometry& p) { return p.id == measured->photometry; });
    if (table == spots.scene.photometries.end() || table->opening.shape == OpeningShape::point) return;
    const Vec3 half{0.5 * table->opening.extent_0, 0.5 * table->opening.extent_90, 0.5 * table->opening.height};
    const Placement placed = placement(luminaire);
    double out = 0.0;
    const double floor = spots.scene.room->floor_height, top = floor + spots.scene.room->height;
    for (const double x : {-half.x, half.x})
        for (const double y : {-half.y, half.y})
            for (const double z : {-half.z, half.z}) {
                const double height = placed.point({x, y, z}).z;
                out = std::max({out, height - top, floor - height});
            }
    if (out > spots.thickness)
        spots.note("luminaires", i, "luminaire", luminaire.name, luminaire.id, "position",
                   "its luminous opening reaches " + figure(out) +
                       " m through the ceiling or floor; a point in its middle would shine whole. Only the part "
                       "inside gives light here and the rest of the flux is lost; lower it by as much");
}

void look_at_luminaires(HardSpots& spots) {
    for (std::size_t i = 0; i < spots.scene.luminaires.size(); ++i) {
        const Luminaire& luminaire = spots.scene.luminaires[i];
        look_at_measured(spots, i, luminaire);
        const auto* const polygon = std::get_if<PolygonOpening>(&luminaire.opening);
        if (polygon != nullptr)
            look_at_opening(spots, i, luminaire, placement(luminaire).region(polygon->region).outline);
    }
}

void look_at_plan(HardSpots& spots, const Room& room) {
    int reflex = 0;
    for (std::size_t k = 0; k < room.plan.size(); ++k) {
        const Vec2 in = room.plan[(k + 1) % room.plan.size()] - room.plan[k];
        const Vec2 out = room.plan[(k + 2) % room.plan.size()] - room.plan[(k + 1) % room.plan.size()];
        if (in.x * out.y - in.y * out.x < -tolerance::parallel * glm::length(in) * glm::length(out)) ++reflex;
    }
    if (reflex > 0)
        spots.note(
            "", 0, "room", room.name, room.id, "plan",
            "its plan has " + std::to_string(reflex) + (reflex == 1 ? " corner that juts" : " corners that jut") +
                " in; walls hide walls and luminaires from each other, which formulas for empty rooms leave out. "
                "What is seen past them is cut exactly here; nothing needs to be done");
}

void look_at_whole(HardSpots& spots) {
    const Bounds bounds = bounds_of(spots.scene);
    const double away = glm::length(0.5 * (bounds.low + bounds.high));
    if (spots.size <= 0.0) return;
    if (away > far_away * spots.size || away > far_away)
        spots.note_whole("room", "the scene lies " + figure(away) +
                                     " m from the origin, where single precision has steps of millimetres. All is "
                                     "computed in double precision about the scene's own middle; nothing needs to be "
                                     "done");
    if (spots.size < 0.3 || spots.size > 1000.0)
        spots.note_whole("room", "the scene measures " + figure(spots.size) +
                                     " m; fixed distances meant for rooms would be far too large or small. All "
                                     "tolerances are shares of the scene; look whether its unit is what you meant, "
                                     "and give a patch width to match");
    if (!spots.scene.room && !spots.scene.surfaces.empty())
        spots.note_whole("surfaces",
                         "there is no room around the surfaces; methods that make every form factor row 1 would "
                         "invent light. What meets no surface is counted as escaped; draw a room if there is one");
}

}  // namespace

void HardSpots::note(std::string_view list, std::size_t index, std::string_view kind, std::string_view name,
                     ObjectId id, std::string_view field, const std::string& message) {
    const auto [known, is_new] = told.try_emplace(message, Told{findings.size(), 0});
    if (!is_new) {
        ++known->second.more;
        return;
    }
    Diagnostic finding;
    finding.severity = Severity::note;
    const std::string of = list.empty() ? std::string(kind) : std::string(list) + '[' + std::to_string(index) + ']';
    finding.place.field = of + '.' + std::string(field);
    finding.place.object = id.value;
    finding.message = std::string(kind) + " \"" + std::string(name) + "\": " + message;
    findings.push_back(std::move(finding));
}

void HardSpots::told_of_others() {
    for (const auto& [message, what] : told)
        if (what.more > 0) findings[what.finding].message += " (the same of " + std::to_string(what.more) + " more)";
}

void HardSpots::note_whole(std::string_view field, const std::string& message) {
    Diagnostic finding;
    finding.severity = Severity::note;
    finding.place.field = field;
    finding.message = message;
    findings.push_back(std::move(finding));
}

Diagnostics hard_spots(const Scene& scene) {
    HardSpots spots{scene, bounds_of(scene).diameter()};
    spots.thickness = tolerance::same_place * spots.size;
    look_at_whole(spots);
    look_at_materials(spots);
    look_at_furniture(spots);
    look_at_surfaces(spots);
    look_at_luminaires(spots);
    look_at_lights(spots);
    look_at_pairs(spots);
    look_at_points(spots, scene.room ? planes_of(*scene.room) : std::vector<Plane>{});
    if (scene.room) look_at_plan(spots, *scene.room);
    spots.told_of_others();
    return std::move(spots.findings);
}

std::string verdict_of(const Diagnostics& findings) {
    if (findings.empty()) return "nothing to complain about";
    const auto count = [&](Severity severity) {
        return std::count_if(findings.begin(), findings.end(),
                             [&](const Diagnostic& finding) { return finding.severity == severity; });
    };
    const auto many = [](std::ptrdiff_t number, const char* word) {
        return std::to_string(number) + ' ' + word + (number == 1 ? "" : "s");
    };
    const auto errors = count(Severity::error), warnings = count(Severity::warning), notes = count(Severity::note);
    std::string text = errors > 0 ? many(errors, "error") : std::string("no errors");
    if (warnings > 0) text += ", " + many(warnings, "warning");
    if (notes > 0) text += "; " + many(notes, "note");
    return text;
}

}  // namespace hanei
