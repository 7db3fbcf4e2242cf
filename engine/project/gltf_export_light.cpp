#include "engine/project/gltf_export_light.h"

#include "engine/geometry/polygon.h"
#include "engine/scene/intensity.h"

#include <algorithm>
#include <numbers>

namespace hanei {
namespace {

constexpr double pi = std::numbers::pi;

/// At full dimmer, lm, and whether it leaves downward in the luminaire's frame.
struct Emitted {
    double flux = 0.0;
    bool downward = false;
};

template <class Object>
const Object* with_id(const std::vector<Object>& list, ObjectId id) {
    const auto found = std::find_if(list.begin(), list.end(), [id](const Object& object) { return object.id == id; });
    return found == list.end() ? nullptr : &*found;
}

Emitted measured_flux(const Luminaire& luminaire, const Scene& scene) {
    constexpr double hardly_any = 0.05;
    const auto* const measured = std::get_if<Measured>(&luminaire.distribution);
    const Photometry* const photometry =
        measured == nullptr ? nullptr : with_id(scene.photometries, measured->photometry);
    if (photometry == nullptr) return {};
    const double flux = luminous_flux(*photometry).value;
    const double down = downward_flux(*photometry).value;
    const auto* const stated = std::get_if<LuminousFlux>(&luminaire.output);
    return {stated != nullptr ? stated->value : flux, flux - down < hardly_any * flux};
}

/// Of the faces that shine, weighted by their share of the luminance.
double weighted_area(const Opening& opening) {
    if (const auto* const polygon = std::get_if<PolygonOpening>(&opening))
        return glm::length(vector_area(polygon->region));
    const auto* const solid = std::get_if<PolyhedronOpening>(&opening);
    double sum = 0.0;
    for (std::size_t f = 0; solid != nullptr && f < solid->faces.size(); ++f) {
        Polygon face;
        for (const int vertex : solid->faces[f]) face.push_back(solid->vertices[static_cast<std::size_t>(vertex)]);
        const double weight = solid->relative_luminance.empty() ? 1.0 : solid->relative_luminance[f];
        sum += weight * glm::length(vector_area(face));
    }
    return sum;
}

Emitted emitted(const Luminaire& luminaire, const Scene& scene) {
    if (std::holds_alternative<Measured>(luminaire.distribution)) return measured_flux(luminaire, scene);
    Emitted result;
    const auto* const polygon = std::get_if<PolygonOpening>(&luminaire.opening);
    const bool looks_down = polygon != nullptr && unit_normal(polygon->region.outline).z < -0.99;
    result.downward = looks_down || std::holds_alternative<CosinePower>(luminaire.distribution);
    if (const auto* const flux = std::get_if<LuminousFlux>(&luminaire.output)) result.flux = flux->value;
    if (const auto* const luminance = std::get_if<Luminance>(&luminaire.output))
        result.flux = pi * luminance->value * weighted_area(luminaire.opening);
    return result;
}

}  // namespace

JsonValue punctual_light(const Luminaire& luminaire, const Scene& scene) {
    const Emitted full = emitted(luminaire, scene);
    const ControlGroup* const group = with_id(scene.control_groups, luminaire.group);
    const double flux = std::max(0.0, full.flux) * luminaire.dimming * scene.maintenance_factor *
                        (group == nullptr ? 1.0 : group->dimming);
    JsonValue light = json_object();
    if (!luminaire.name.empty()) light.add("name", json_text(luminaire.name));
    light.add("type", json_text(full.downward ? "spot" : "point"));
    light.add("intensity", json_number(full.downward ? 1.5 * flux / pi : 0.25 * flux / pi));
    if (full.downward) {
        JsonValue& cone = light.add("spot", json_object());
        cone.add("innerConeAngle", json_number(0.0));
        cone.add("outerConeAngle", json_number(pi / 2.0));
    }
    return light;
}

}  // namespace hanei
