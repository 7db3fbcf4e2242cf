#include "engine/geometry/polygon.h"
#include "engine/scene/grid_spacing.h"
#include "engine/scene/scene_findings.h"

#include <cmath>
#include <numbers>

namespace hanei {
namespace {

void check_part(SceneChecks& checks, ObjectFindings& object, const Part& part, const std::string& field) {
    object.finite(field + ".position", part.position);
    object.finite(field + ".rotation_deg", {part.rotation});
    checks.check_material(object, field + ".material", part.material);
    if (const auto* const box = std::get_if<BoxShape>(&part.shape)) {
        const bool good = object.positive(field + ".box", box->size.x) &&
                          object.positive(field + ".box", box->size.y) && object.positive(field + ".box", box->size.z);
        static_cast<void>(good);  // one finding a box is enough
    }
    if (const auto* const solid = std::get_if<SolidShape>(&part.shape))
        check_solid(object, field + ".faces", solid->vertices, solid->faces);
}

void check_grid(SceneChecks& checks, const CalculationGrid& grid, std::size_t index) {
    ObjectFindings object = checks.about("grids", index, "grid", grid.name, grid.id);
    checks.check_id(object, grid.id);
    const bool finite = object.finite("corner", grid.corner) && object.finite("along", grid.along) &&
                        object.finite("across", grid.across);
    const bool spaced = object.positive("spacing", grid.spacing);
    if (!finite) return;
    const Polygon triangle{Vec3{0.0}, grid.along, grid.across};
    if (unit_normal(triangle) == Vec3{0.0})
        return object.error("across",
                            "the grid has no area; its two sides must have a length and different directions");
    if (!spaced) return;
    const double points = grid_points(grid);
    if (points > most_grid_points)
        object.error("spacing", "a spacing of " + figure(grid.spacing) + " m makes " + figure(points) +
                                    " points, at most a million can be computed; widen it");
}

void check_point(SceneChecks& checks, const CalculationPoint& point, std::size_t index) {
    constexpr double unit = 1e-9;  // a normal written with ten digits passes; cosines err by as much
    ObjectFindings object = checks.about("points", index, "point", point.name, point.id);
    checks.check_id(object, point.id);
    object.finite("position", point.position);
    if (!object.finite("normal", point.normal)) return;
    const double length = glm::length(point.normal);
    if (std::abs(length - 1.0) > unit)
        object.error("normal", "the normal is " + figure(length) + " long, it must be 1; divide it by its length");
}

void check_cut(ObjectFindings& object, const View& view) {
    constexpr double unit = 1e-9;  // as of calculation points
    if (!view.cut || !object.finite("cut.normal", view.cut->normal)) return;
    object.finite("cut.offset", {view.cut->offset});
    const double length = glm::length(view.cut->normal);
    if (std::abs(length - 1.0) > unit)
        object.error("cut.normal", "the normal is " + figure(length) + " long, it must be 1; divide it by its length");
}

void check_view(SceneChecks& checks, const View& view, std::size_t index) {
    ObjectFindings object = checks.about("views", index, "view", view.name, view.id);
    checks.check_id(object, view.id);
    const bool finite = object.finite("eye", view.eye) && object.finite("target", view.target);
    if (finite && glm::distance(view.eye, view.target) <= 0.0)
        object.error("target", "eye and target are the same place; move one of them");
    check_cut(object, view);
    if (!object.finite("field_of_view_deg", {view.field_of_view})) return;
    if (!(view.field_of_view > 0.0 && view.field_of_view < std::numbers::pi))
        object.error("field_of_view_deg", "found " + figure(view.field_of_view * 180.0 / std::numbers::pi) +
                                              " degrees, allowed is more than 0 and less than 180");
}

}  // namespace

void check_furniture(SceneChecks& checks) {
    for (std::size_t i = 0; i < checks.scene.furniture.size(); ++i) {
        const Furniture& furniture = checks.scene.furniture[i];
        ObjectFindings object = checks.about("furniture", i, "furniture", furniture.name, furniture.id);
        checks.check_id(object, furniture.id);
        object.finite("position", furniture.position);
        object.finite("rotation_deg", {furniture.rotation});
        if (furniture.parts.empty()) object.warn("parts", "it has no parts and cannot be seen; remove it or add one");
        for (std::size_t k = 0; k < furniture.parts.size(); ++k)
            check_part(checks, object, furniture.parts[k], "parts[" + std::to_string(k) + ']');
    }
}

void check_surfaces(SceneChecks& checks) {
    for (std::size_t i = 0; i < checks.scene.surfaces.size(); ++i) {
        const FreeSurface& surface = checks.scene.surfaces[i];
        ObjectFindings object = checks.about("surfaces", i, "surface", surface.name, surface.id);
        checks.check_id(object, surface.id);
        checks.check_material(object, "material", surface.material);
        check_region(object, "", surface.region);
        if (object.finite("exitance_lm_m2", {surface.own_exitance.value}) && surface.own_exitance.value < 0.0)
            object.error("exitance_lm_m2", "found " + figure(surface.own_exitance.value) + ", it cannot be negative");
    }
}

void check_calculation(SceneChecks& checks) {
    const Scene& scene = checks.scene;
    for (std::size_t i = 0; i < scene.grids.size(); ++i) check_grid(checks, scene.grids[i], i);
    for (std::size_t i = 0; i < scene.points.size(); ++i) check_point(checks, scene.points[i], i);
    for (std::size_t i = 0; i < scene.views.size(); ++i) check_view(checks, scene.views[i], i);
}

}  // namespace hanei
