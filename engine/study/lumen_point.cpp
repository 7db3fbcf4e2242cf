#include "engine/study/lumen_point.h"

#include "engine/direct/direct.h"
#include "engine/edit/lumen_method.h"
#include "engine/geometry/polygon.h"
#include "engine/scene/dimmers.h"
#include "engine/scene/faces.h"
#include "engine/study/study.h"
#include "engine/study/value_stage.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <vector>

namespace hanei {
namespace {

/// m above the floor: of the largest grid that lies level and looks up.
double working_plane_of(const Scene& scene) {
    constexpr double usual = 0.75;
    double height = usual, largest = 0.0;
    for (const CalculationGrid& grid : scene.grids) {
        const Vec3 across = glm::cross(grid.along, grid.across);
        const double above = grid.corner.z - scene.room->floor_height;
        if (across.z < 0.999 * glm::length(across) || across.z <= largest) continue;
        if (above < 0.0 || above >= scene.room->height) continue;
        largest = across.z;
        height = above;
    }
    return height;
}

bool is_inside(const std::vector<Vec2>& plan, const Vec2& place) {
    bool inside = false;
    for (std::size_t k = 0, before = plan.size() - 1; k < plan.size(); before = k++) {
        const Vec2 &a = plan[k], &b = plan[before];
        if ((a.y > place.y) != (b.y > place.y) && place.x < (b.x - a.x) * (place.y - a.y) / (b.y - a.y) + a.x)
            inside = !inside;
    }
    return inside;
}

/// Over a raster of the plan.
double solved_mean(const Solution& solution, double height) {
    constexpr int raster = 20;
    const Room& room = *solution.scene->room;
    Vec2 low = room.plan.front(), high = low;
    for (const Vec2& corner : room.plan) {
        low = glm::min(low, corner);
        high = glm::max(high, corner);
    }
    double sum = 0.0;
    int count = 0;
    for (int k = 0; k < raster * raster; ++k) {
        const Vec2 share{(k % raster + 0.5) / raster, (k / raster + 0.5) / raster};
        const Vec2 place = low + share * (high - low);
        if (!is_inside(room.plan, place)) continue;
        const PointValue value = value_at(solution, {place, room.floor_height + height}, {0.0, 0.0, 1.0});
        if (value.inside_solid) continue;
        sum += value.total().value;
        ++count;
    }
    return count > 0 ? sum / count : 0.0;
}

std::string refusal_of(const Scene& scene) {
    if (!scene.room || scene.room->plan.size() < 3) return "there is no room";
    if (scene.luminaires.empty()) return "there is no luminaire";
    for (const Face& face : faces_of(scene))
        if (face.own_exitance.value > 0.0) return "surfaces shine by themselves";
    return {};
}

/// Alike in all but the place: then the utilization factor is the same.
bool are_alike(Luminaire a, const Luminaire& b) {
    a.id = b.id;
    a.name = b.name;
    a.position.x = b.position.x;
    a.position.y = b.position.y;
    a.dimming = b.dimming;
    return a == b;
}

double predicted_mean(const Scene& scene, double height) {
    LumenWish wish;
    wish.working_plane = height;
    double flux = 0.0, factor = 0.0;
    const Luminaire* last = nullptr;
    for (const Luminaire& luminaire : scene.luminaires) {
        if (last == nullptr || !are_alike(*last, luminaire)) {
            wish.mounting = mounting_of(scene, luminaire);
            factor = utilization_factor(scene, luminaire, wish);
        }
        last = &luminaire;
        flux += factor * dimming_of(scene, luminaire) * Emitter(scene, luminaire).flux().value;
    }
    const double area = std::abs(signed_area(scene.room->plan));
    return area > 0.0 ? flux * scene.maintenance_factor / area : 0.0;
}

}  // namespace

LumenPoint lumen_point(const Solution& solution) {
    LumenPoint point;
    const Scene& scene = *solution.scene;
    point.refusal = refusal_of(scene);
    if (!point.refusal.empty()) return point;
    point.working_plane = working_plane_of(scene);
    const auto begin = std::chrono::steady_clock::now();
    point.predicted = predicted_mean(scene, point.working_plane);
    point.milliseconds = std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begin).count();
    point.solved = solved_mean(solution, point.working_plane);
    if (!(point.predicted > 0.0) || !(point.solved > 0.0)) point.refusal = "no light reaches the working plane";
    return point;
}

}  // namespace hanei
