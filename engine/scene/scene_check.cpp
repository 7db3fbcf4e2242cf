#include "engine/scene/scene_check.h"

#include "engine/scene/scene_findings.h"

#include <algorithm>

namespace hanei {

void check_materials(SceneChecks& checks) {
    for (std::size_t i = 0; i < checks.scene.materials.size(); ++i) {
        const Material& material = checks.scene.materials[i];
        ObjectFindings object = checks.about("materials", i, "material", material.name, material.id);
        checks.check_id(object, material.id);
        object.within("reflectance", material.reflectance, 0.0, 1.0);
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
    if (!has_errors(checks.findings)) {
        check_places(checks);
        check_overlaps(checks);
    }
    return std::move(checks.findings);
}

}  // namespace hanei
