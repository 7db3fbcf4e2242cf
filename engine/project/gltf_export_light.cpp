#include "engine/project/gltf_export_light.h"

#include "engine/edit/intensity_of.h"
#include "engine/edit/luminaire_edits.h"
#include "engine/geometry/polygon.h"
#include "engine/scene/dimmers.h"
#include "engine/scene/intensity.h"

#include <algorithm>
#include <numbers>

namespace hanei {
namespace {

constexpr double pi = std::numbers::pi;

/// Whether less than a twentieth of it goes upward in the luminaire's frame.
bool shines_down(const Luminaire& luminaire, const Scene& scene) {
    constexpr double hardly_any = 0.05;
    if (const Photometry* const photometry = photometry_of(scene, luminaire)) {
        const double flux = luminous_flux(*photometry).value;
        return flux - downward_flux(*photometry).value < hardly_any * flux;
    }
    const auto* const polygon = std::get_if<PolygonOpening>(&luminaire.opening);
    const bool looks_down = polygon != nullptr && unit_normal(polygon->region.outline).z < -0.99;
    return looks_down || std::holds_alternative<CosinePower>(luminaire.distribution);
}

}  // namespace

double burning_share(const Luminaire& luminaire, const Scene& scene) {
    return dimming_of(scene, luminaire) * scene.maintenance_factor;
}

JsonValue punctual_light(const Luminaire& luminaire, const Scene& scene) {
    const double flux = std::max(0.0, IntensityOf(scene, luminaire).flux()) * burning_share(luminaire, scene);
    const bool downward = shines_down(luminaire, scene);
    JsonValue light = json_object();
    if (!luminaire.name.empty()) light.add("name", json_text(luminaire.name));
    light.add("type", json_text(downward ? "spot" : "point"));
    light.add("intensity", json_number(downward ? 1.5 * flux / pi : 0.25 * flux / pi));
    if (downward) {
        JsonValue& cone = light.add("spot", json_object());
        cone.add("innerConeAngle", json_number(0.0));
        cone.add("outerConeAngle", json_number(pi / 2.0));
    }
    return light;
}

}  // namespace hanei
