#include "ui/panels/wall_distances.h"

#include "engine/edit/plan_shape.h"
#include "engine/edit/several.h"
#include "engine/scene/faces.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace hanei {
namespace {

constexpr double least = 0.005;  // m: less is at the wall

/// Along the axis, from the place, the nearest wall that way.
std::optional<double> wall_along(const std::vector<Vec2>& plan, const Vec2& place, int axis, double sign) {
    std::optional<double> nearest;
    const int other = 1 - axis;
    for (std::size_t k = 0; k < plan.size(); ++k) {
        const Vec2 a = plan[k], b = plan[(k + 1) % plan.size()];
        const bool crosses = (a[other] <= place[other]) != (b[other] <= place[other]);
        if (!crosses) continue;
        const double share = (place[other] - a[other]) / (b[other] - a[other]);
        const double at = a[axis] + share * (b[axis] - a[axis]);
        const double away = sign * (at - place[axis]);
        if (away > -1e-9 && (!nearest || away < sign * (*nearest - place[axis]))) nearest = at;
    }
    return nearest;
}

}  // namespace

std::vector<WallDistance> wall_distances(const Scene& scene, std::span<const ObjectId> chosen) {
    std::vector<WallDistance> distances;
    if (!scene.room || chosen.empty()) return distances;
    std::optional<Bounds> bounds = bounds_of_objects(scene, chosen);
    if (chosen.size() == 1 && kind_of(scene, chosen.front()) == ObjectKind::luminaire) {
        const Vec3 place = *place_of(scene, chosen.front());
        bounds = Bounds{place, place};
    }
    if (!bounds) return distances;
    const Vec3 middle = 0.5 * (bounds->low + bounds->high);
    if (!plan_holds(scene.room->plan, Vec2(middle))) return distances;
    for (int axis = 0; axis < 2; ++axis) {
        for (const double sign : {-1.0, 1.0}) {
            Vec3 from = middle;
            from[axis] = sign < 0.0 ? bounds->low[axis] : bounds->high[axis];
            const std::optional<double> wall = wall_along(scene.room->plan, Vec2(from), axis, sign);
            if (!wall || std::abs(*wall - from[axis]) < least) continue;
            Vec3 to = from;
            to[axis] = *wall;
            distances.push_back({axis, from, to});
        }
    }
    return distances;
}

}  // namespace hanei
