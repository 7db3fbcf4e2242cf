#include "engine/edit/free_place.h"

#include "engine/edit/hanging.h"
#include "engine/edit/plan_shape.h"

#include <algorithm>
#include <cmath>

namespace hanei {
namespace {

constexpr double raster = 0.2;     // m: finer finds hardly more
constexpr double passage = 0.05;   // m, between neighbours
constexpr double headroom = 0.02;  // m: what hangs above that does not stand in the way

std::vector<Bounds> standing(const Scene& scene, double floor, double height) {
    std::vector<Bounds> all;
    for (const Furniture& furniture : scene.furniture) {
        Scene alone;
        alone.furniture.push_back(furniture);
        const Bounds bounds = bounds_of(alone);
        if (bounds.low.z < floor + height - headroom && bounds.high.z > floor + headroom) all.push_back(bounds);
    }
    return all;
}

bool apart(const Bounds& a, const Bounds& b) {
    return a.high.x + passage <= b.low.x || b.high.x + passage <= a.low.x || a.high.y + passage <= b.low.y ||
           b.high.y + passage <= a.low.y;
}

}  // namespace

Vec3 free_place(const Scene& scene, const Bounds& own) {
    const PlanBounds plan = bounds_of_plan(scene);
    const double floor = scene.room ? scene.room->floor_height : 0.0;
    const Vec2 wished = plan.middle();
    const Vec2 middle{std::round(wished.x * 10.0) / 10.0, std::round(wished.y * 10.0) / 10.0};
    const std::vector<Bounds> taken = standing(scene, floor, own.high.z - own.low.z);
    const Vec2 half = 0.5 * (plan.high - plan.low);
    const int reach = std::min(200, static_cast<int>(std::max(half.x, half.y) / raster) + 1);
    Vec3 best{middle, floor};
    double nearest = HUGE_VAL;
    for (int row = -reach; row <= reach; ++row)
        for (int column = -reach; column <= reach; ++column) {
            const double distance = std::hypot(row, column);
            if (distance >= nearest) continue;
            const Vec3 place{middle + raster * Vec2{static_cast<double>(column), static_cast<double>(row)}, floor};
            const Bounds there{place + own.low, place + own.high};
            const bool inside = !scene.room || plan_holds(scene.room->plan, Vec2{there.low}, Vec2{there.high});
            const bool clear =
                std::all_of(taken.begin(), taken.end(), [&](const Bounds& other) { return apart(there, other); });
            if (!inside || !clear) continue;
            nearest = distance;
            best = place;
        }
    return best;
}

}  // namespace hanei
