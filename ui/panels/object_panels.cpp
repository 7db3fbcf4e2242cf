#include "engine/edit/edit.h"
#include "engine/scene/colour.h"
#include "ui/panels/properties.h"
#include "ui/panels/property_rows.h"

#include <algorithm>
#include <fmt/format.h>

namespace hanei {
namespace {

/// Edits a copy of the object of this id; the scene with it in place when `rows` changed it.
template <class Object, class Rows>
std::optional<Scene> edited(const Scene& scene, std::vector<Object> Scene::*list, ObjectId id, const Rows& rows) {
    const std::vector<Object>& objects = scene.*list;
    for (std::size_t k = 0; k < objects.size(); ++k) {
        if (objects[k].id != id) continue;
        Object object = objects[k];
        if (!rows(object)) return std::nullopt;
        Scene wished = scene;
        (wished.*list)[k] = std::move(object);
        return wished;
    }
    return std::nullopt;
}

bool part_rows(const Scene& scene, Furniture& furniture, Form& form) {
    bool changed = false;
    for (std::size_t k = 0; k < furniture.parts.size(); ++k) {
        Part& part = furniture.parts[k];
        const std::string owner = fmt::format("part{}", k + 1);
        form.heading(furniture.parts.size() == 1 ? "Body" : fmt::format("Part {}", k + 1).c_str());
        if (auto* box = std::get_if<BoxShape>(&part.shape)) {
            const auto side = [&](const char* axis, const char* label, double& length) {
                const std::string name = owner + "." + axis;
                changed |= form.number({name.c_str(), label, "m", "Size of the box", 0.001, 1000.0, 0.01, 3}, length);
            };
            side("width", "Width", box->size.x);
            side("depth", "Depth", box->size.y);
            side("height", "Height", box->size.z);
        } else {
            form.fact("Shape", "Convex solid");
        }
        const std::string material = owner + ".material";
        changed |= material_row(material.c_str(), "Material", scene, part.material, form);
    }
    return changed;
}

}  // namespace

std::optional<Scene> furniture_panel(const Scene& scene, ObjectId id, Form& form) {
    return edited(scene, &Scene::furniture, id, [&](Furniture& furniture) {
        bool changed = form.text("furniture.name", "Name", "What this piece is called", furniture.name);
        form.heading("Place");
        changed |= place_rows("furniture", furniture.position, form);
        changed |= angle_row({"furniture.rotation", "Turn", "°", "About the vertical, counter-clockwise from above",
                              -360.0, 360.0, 0.5, 1},
                             furniture.rotation, form);
        return part_rows(scene, furniture, form) || changed;
    });
}

std::optional<Scene> room_panel(const Scene& scene, Form& form) {
    if (!scene.room) return std::nullopt;
    Room room = *scene.room;
    bool changed = form.text("room.name", "Name", "What this room is called", room.name);
    changed |= form.number({"room.height", "Height", "m", "Clear height from floor to ceiling", 0.1, 1000.0, 0.01, 3},
                           room.height);
    changed |=
        form.number({"room.floor", "Floor at", "m", "Height of the floor", -1e4, 1e4, 0.01, 3}, room.floor_height);
    form.heading("Faces");
    changed |= material_row("room.ceiling", "Ceiling", scene, room.ceiling_material, form);
    changed |= material_row("room.floor_material", "Floor", scene, room.floor_material, form);
    for (std::size_t k = 0; k < room.wall_materials.size(); ++k) {
        const std::string name = fmt::format("room.wall{}", k + 1);
        changed |=
            material_row(name.c_str(), fmt::format("Wall {}", k + 1).c_str(), scene, room.wall_materials[k], form);
    }
    if (!room.sub_areas.empty()) form.heading("Doors, windows, boards");
    for (SubArea& area : room.sub_areas) {
        const std::string name = fmt::format("room.area{}", area.id.value);
        changed |=
            material_row(name.c_str(), area.name.empty() ? "Area" : area.name.c_str(), scene, area.material, form);
    }
    form.heading("Plan");
    for (std::size_t k = 0; k < room.plan.size(); ++k) {
        const std::string x = fmt::format("room.plan{}.x", k + 1);
        const std::string y = fmt::format("room.plan{}.y", k + 1);
        const std::string label_x = fmt::format("Corner {}  x", k + 1);
        changed |=
            form.number({x.c_str(), label_x.c_str(), "m", "Corner of the plan", -1e4, 1e4, 0.01, 3}, room.plan[k].x);
        changed |= form.number({y.c_str(), "y", "m", "Corner of the plan", -1e4, 1e4, 0.01, 3}, room.plan[k].y);
    }
    if (!changed) return std::nullopt;
    Scene wished = scene;
    wished.room = std::move(room);
    return wished;
}

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

std::optional<Scene> material_panel(const Scene& scene, ObjectId id, Form& form) {
    return edited(scene, &Scene::materials, id, [&](Material& material) {
        bool changed = form.text("material.name", "Name", "What this material is called", material.name);
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

std::optional<Scene> grid_panel(const Scene& scene, ObjectId id, Form& form) {
    return edited(scene, &Scene::grids, id, [&](CalculationGrid& grid) {
        bool changed = form.text("grid.name", "Name", "What this grid is called in tables", grid.name);
        changed |= form.number({"grid.spacing", "Spacing", "m", "Wished distance between points", 0.01, 100.0, 0.01, 3},
                               grid.spacing);
        form.heading("First corner");
        changed |= place_rows("grid", grid.corner, form);
        const auto side = [&](const char* name, const char* label, Vec3& edge) {
            double length = glm::length(edge);
            if (!form.number({name, label, "m", "Side of the grid", 0.01, 1e4, 0.01, 3}, length)) return;
            edge *= length / glm::length(edge);
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
            angle_row({"view.angle", "Field of view", "°", "Vertical", 1.0, 170.0, 0.2, 1}, view.field_of_view, form);
        changed |= form.toggle("view.orthographic", "To scale", "Parallel projection instead of perspective",
                               view.orthographic);
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
        case ObjectKind::control_group:
        case ObjectKind::light_scene:
        case ObjectKind::arrangement:
        case ObjectKind::object_group:
            return project_panel(scene, form);
        case ObjectKind::room:
            return room_panel(scene, form);
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
