#include "engine/scene/scene_check.h"

#include "engine/scene/colour.h"
#include "engine/scene/scene_findings.h"

#include <algorithm>
#include <cmath>

namespace hanei {
namespace {

std::string three(const Vec3& bands) { return figure(bands.x) + ", " + figure(bands.y) + ", " + figure(bands.z); }

/// Three shares, 0 or more, of luminance 1, of which none makes a band reflect more than it gets.
void check_tint(ObjectFindings& object, const Material& material) {
    const Vec3& tint = material.tint;
    if (!object.finite("tint", tint)) return;
    if (tint.x < 0.0 || tint.y < 0.0 || tint.z < 0.0) {
        object.error("tint", "found " + three(tint) + ", allowed are three figures, 0 or more");
        return;
    }
    if (const double mean = luminance(tint); std::abs(mean - 1.0) > tint_tolerance) {
        object.error("tint", "found " + three(tint) + " of luminance " + figure(mean) +
                                 ", allowed is a luminance of 1 (0.2126 red + 0.7152 green + 0.0722 blue)" +
                                 (mean > 0.0 ? "; write " + three(tint / mean) : ""));
        return;
    }
    const double greatest = std::max({tint.x, tint.y, tint.z});
    constexpr double rounding = 1e-9;  // of a tint made for this reflectance
    if (material.reflectance <= 1.0 && material.reflectance * greatest > 1.0 + rounding)
        object.error("tint", "found " + three(tint) + ": with a reflectance of " + figure(material.reflectance) +
                                 " a band would reflect " + figure(material.reflectance * greatest) +
                                 ", allowed is 1 at most; lower the reflectance to " + figure(1.0 / greatest) +
                                 " or choose a paler colour");
}

}  // namespace

void check_materials(SceneChecks& checks) {
    for (std::size_t i = 0; i < checks.scene.materials.size(); ++i) {
        const Material& material = checks.scene.materials[i];
        ObjectFindings object = checks.about("materials", i, "material", material.name, material.id);
        checks.check_id(object, material.id);
        object.within("reflectance", material.reflectance, 0.0, 1.0);
        check_tint(object, material);
    }
}

Diagnostics check_scene(const Scene& scene) {
    SceneChecks checks{scene, {}, {}};
    ObjectFindings whole(checks.findings, {}, "project", scene.title, {});
    whole.within("maintenance_factor", scene.maintenance_factor, 0.0, 1.0);
    check_materials(checks);
    check_room(checks);
    check_furniture(checks);
    check_surfaces(checks);
    check_photometries(checks);
    check_luminaires(checks);
    check_calculation(checks);
    check_colour_scale(checks);
    check_groups(checks);
    check_lighting(checks);
    if (!has_errors(checks.findings)) {
        check_places(checks);
        check_overlaps(checks);
    }
    return std::move(checks.findings);
}

}  // namespace hanei
