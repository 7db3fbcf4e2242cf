#include "engine/edit/edit.h"
#include "engine/scene/grid_spacing.h"
#include "ui/panels/edited_object.h"
#include "ui/panels/properties.h"
#include "ui/panels/property_rows.h"
#include "ui/panels/room_panel.h"
#include "ui/panels/section.h"

#include <algorithm>
#include <fmt/format.h>

namespace hanei {

std::optional<Scene> surface_panel(const Scene& scene, ObjectId id, Form& form) {
    return edited(scene, &Scene::surfaces, id, [&](FreeSurface& surface) {
        bool changed = form.text("surface.name", "Name", "What this surface is called", surface.name);
        changed |= material_row("surface.material", "Material", scene, surface.material, form);
        changed |= form.number(
            {"surface.exitance", "Own light", "lm/m²", "Luminous exitance of its own, diffuse", 0.0, 1e9, 1.0, 1},
            surface.own_exitance.value);
        form.fact("Corners", std::to_string(surface.region.outline.size()));
        return changed;
    });
}

std::optional<Scene> grid_panel(const Scene& scene, ObjectId id, Form& form) {
    return edited(scene, &Scene::grids, id, [&](CalculationGrid& grid) {
        bool changed = form.text("grid.name", "Name", "What this grid is called in tables", grid.name);
        changed |= form.number({"grid.spacing", "Spacing", "m", "Wished distance between points",
                                std::max(0.01, least_spacing(grid)), 1000.0, 0.01, 3},
                               grid.spacing);
        form.heading("First corner");
        changed |= place_rows("grid", grid.corner, form);
        const auto side = [&](const char* name, const char* label, Vec3& edge) {
            double length = glm::length(edge);
            if (!form.number({name, label, "m", "Side of the grid", 0.01, 1e4, 0.01, 3}, length)) return;
            edge *= length / glm::length(edge);
            grid.spacing = std::max(grid.spacing, least_spacing(grid));
            changed = true;
        };
        form.heading("Size");
        side("grid.along", "Along", grid.along);
        side("grid.across", "Across", grid.across);
        return changed;
    });
}

std::optional<Scene> point_panel(const Scene& scene, ObjectId id, Form& form) {
    return edited(scene, &Scene::points, id, [&](CalculationPoint& point) {
        bool changed = form.text("point.name", "Name", "What this point is called in tables", point.name);
        form.heading("Place");
        changed |= place_rows("point", point.position, form);
        form.fact("Faces", fmt::format("{:.2f}  {:.2f}  {:.2f}", point.normal.x, point.normal.y, point.normal.z));
        return changed;
    });
}

std::optional<Scene> view_panel(const Scene& scene, ObjectId id, Form& form) {
    return edited(scene, &Scene::views, id, [&](View& view) {
        bool changed = form.text("view.name", "Name", "What this view is called", view.name);
        changed |=
            angle_row({"view.angle", "Field of view", "°",
                       "Of the perspective, from the lower to the upper edge of the picture; the eye stays where it is",
                       least_field_of_view, greatest_field_of_view, 0.2, 1},
                      view.field_of_view, form);
        changed |= form.toggle("view.orthographic", "To scale", "Parallel projection instead of perspective",
                               view.orthographic);
        changed |= form.toggle("view.hides_ceiling", "Without ceiling",
                               "The ceiling is taken off, as of a doll's house", view.hides_ceiling);
        form.heading("Eye");
        changed |= place_rows("view.eye", view.eye, form);
        form.heading("Looks at");
        changed |= place_rows("view.target", view.target, form);
        return changed;
    });
}

std::optional<Scene> project_panel(const Scene& scene, Form& form) {
    Scene wished = scene;
    bool changed = form.text("project.title", "Title", "Title of pictures and tables", wished.title);
    changed |=
        percent_row({"project.maintenance", "Maintenance", "%",
                     "Maintenance factor: multiplies the output of every luminaire (EN 12464-1)", 0.0, 100.0, 0.2, 1},
                    wished.maintenance_factor, form);
    form.heading("Contents");
    form.fact("Luminaires", std::to_string(scene.luminaires.size()));
    form.fact("Furniture", std::to_string(scene.furniture.size()));
    form.fact("Grids", std::to_string(scene.grids.size()));
    form.fact("Points", std::to_string(scene.points.size()));
    if (!changed) return std::nullopt;
    return wished;
}

std::optional<Scene> object_panel(const Scene& scene, ObjectId id, Form& form) {
    switch (kind_of(scene, id)) {
        case ObjectKind::none:
        case ObjectKind::object_group:
            return project_panel(scene, form);
        case ObjectKind::sub_area:
            return sub_area_panel(scene, id, form);
        case ObjectKind::control_group:
            return control_group_panel(scene, id, form);
        case ObjectKind::light_scene:
            return light_scene_panel(scene, id, form);
        case ObjectKind::arrangement:
            return arrangement_panel(scene, id, form);
        case ObjectKind::room:
            return [&] {
                RoomFocus focus;
                return room_panel(scene, focus, form);
            }();
        case ObjectKind::furniture:
            return furniture_panel(scene, id, form);
        case ObjectKind::surface:
            return surface_panel(scene, id, form);
        case ObjectKind::luminaire:
            return luminaire_panel(scene, id, form);
        case ObjectKind::grid:
            return grid_panel(scene, id, form);
        case ObjectKind::point:
            return point_panel(scene, id, form);
        case ObjectKind::view:
            return view_panel(scene, id, form);
        case ObjectKind::material:
            return material_panel(scene, id, form);
    }
    return std::nullopt;
}

}  // namespace hanei
