#include "engine/edit/start_layout.h"

#include "engine/edit/arrangements.h"
#include "engine/edit/hanging.h"
#include "engine/edit/luminaire_edits.h"
#include "engine/scene/grid_spacing.h"

#include <algorithm>
#include <cmath>

namespace hanei {
namespace {

constexpr double same_height = 1e-6;  // m

void add_working_plane(Scene& scene, const LumenWish& wish) {
    const double height = (scene.room ? scene.room->floor_height : 0.0) + wish.working_plane;
    for (const CalculationGrid& grid : scene.grids)
        if (grid.name == working_plane_name && std::abs(grid.corner.z - height) < same_height) return;
    const PlanBounds plan = bounds_of_plan(scene);
    const Vec2 size = plan.high - plan.low;
    const double border = std::min(wish.border, 0.2 * std::min(size.x, size.y));
    CalculationGrid grid;
    grid.id = scene.new_id();
    grid.name = working_plane_name;
    grid.corner = Vec3(plan.low + Vec2(border), height);
    grid.along = {size.x - 2.0 * border, 0.0, 0.0};
    grid.across = {0.0, size.y - 2.0 * border, 0.0};
    grid.spacing = standard_spacing(grid);
    scene.grids.push_back(std::move(grid));
}

}  // namespace

Added with_start_layout(Scene scene, ObjectId luminaire, const LumenWish& wish, const LumenAnswer& answer) {
    const ObjectId one[] = {luminaire};
    const Arrangement* const before = arrangement_of(scene, luminaire);
    ObjectId id = before ? before->id : ObjectId{};
    const double yaw = before ? before->yaw : 0.0;
    scene = mounted(std::move(scene), one, wish.mounting);
    const Luminaire* const hung = find_luminaire(scene, luminaire);
    if (!hung) return {std::move(scene), {}};
    const Layout layout = field_over_room(scene, hung->position.z, answer.columns, answer.rows);
    if (id) {
        scene = with_layout(std::move(scene), id, layout, yaw);
    } else {
        Added added = arranged(std::move(scene), luminaire, layout);
        scene = std::move(added.scene);
        id = added.object;
    }
    add_working_plane(scene, wish);
    return {std::move(scene), id};
}

ObjectId working_plane_of(const Scene& scene) {
    for (const CalculationGrid& grid : scene.grids)
        if (grid.name == working_plane_name) return grid.id;
    return {};
}

Scene with_output_scaled(Scene scene, ObjectId arrangement, double factor) {
    const Arrangement* const found = find_arrangement(scene, arrangement);
    if (!found || !std::isfinite(factor)) return scene;
    for (Luminaire& luminaire : scene.luminaires)
        if (arrangement_of(scene, luminaire.id) == found)
            luminaire.dimming = std::clamp(luminaire.dimming * factor, 0.0, 1.0);
    return scene;
}

}  // namespace hanei
