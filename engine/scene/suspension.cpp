#include "engine/scene/suspension.h"

#include "engine/scene/placement.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace hanei {
namespace {

const MeasuredOpeningSize* opening_size(const Scene& scene, const Luminaire& luminaire) {
    const auto* measured = std::get_if<Measured>(&luminaire.distribution);
    if (!measured) return nullptr;
    const auto found = std::find_if(scene.photometries.begin(), scene.photometries.end(),
                                    [&](const Photometry& each) { return each.id == measured->photometry; });
    return found == scene.photometries.end() ? nullptr : &found->opening;
}

}  // namespace

Vec3 half_extent(const Scene& scene, const Luminaire& luminaire) {
    Vec3 half{0.0};
    const auto include = [&](const Vec3& corner) { half = glm::max(half, glm::abs(corner)); };
    if (const auto* line = std::get_if<LineOpening>(&luminaire.opening)) {
        include(line->from);
        include(line->to);
    } else if (const auto* flat = std::get_if<PolygonOpening>(&luminaire.opening)) {
        for (const Vec3& corner : flat->region.outline) include(corner);
    } else if (const auto* solid = std::get_if<PolyhedronOpening>(&luminaire.opening)) {
        for (const Vec3& corner : solid->vertices) include(corner);
    } else if (std::holds_alternative<MeasuredOpening>(luminaire.opening)) {
        const MeasuredOpeningSize* const size = opening_size(scene, luminaire);
        if (size && size->shape != OpeningShape::point)
            half = 0.5 * Vec3(size->extent_0, size->extent_90, size->height);
    }
    return half;
}

double reach_along(const Scene& scene, const Luminaire& luminaire, const Vec3& direction) {
    const Vec3 own = glm::transpose(placement(luminaire).rotation) * direction;
    return glm::dot(glm::abs(own), half_extent(scene, luminaire));
}

double reach_upward(const Scene& scene, const Luminaire& luminaire) {
    return reach_along(scene, luminaire, {0.0, 0.0, 1.0});
}

std::optional<std::pair<Vec3, Vec3>> suspension_of(const Scene& scene, const Luminaire& luminaire) {
    if (!scene.room || !is_over_plan(*scene.room, Vec2(luminaire.position))) return std::nullopt;
    const Room& room = *scene.room;
    const Vec3 top = luminaire.position + Vec3(0.0, 0.0, reach_upward(scene, luminaire));
    const double ceiling = room.floor_height + room.height;
    const bool is_high = luminaire.position.z > room.floor_height + 0.5 * room.height;
    if (!is_high || top.z > ceiling - shortest_suspension || hangs_on_wall(scene, luminaire)) return std::nullopt;
    return std::pair{top, Vec3(top.x, top.y, ceiling)};
}

WallFoot nearest_wall(const Room& room, const Vec2& place) {
    WallFoot nearest;
    nearest.distance = std::numeric_limits<double>::infinity();
    for (std::size_t k = 0; k < room.plan.size(); ++k) {
        const Vec2 a = room.plan[k], edge = room.plan[(k + 1) % room.plan.size()] - a;
        const double length = glm::length(edge);
        if (!(length > 0.0)) continue;
        const double along = std::clamp(glm::dot(place - a, edge) / (length * length), 0.0, 1.0);
        const Vec2 foot = a + along * edge;
        const double distance = glm::length(place - foot);
        if (distance < nearest.distance) nearest = {foot, Vec2(-edge.y, edge.x) / length, distance};
    }
    return nearest;
}

bool hangs_on_wall(const Scene& scene, const Luminaire& luminaire) {
    constexpr double nearly = 0.05;  // m
    if (!scene.room) return false;
    const WallFoot wall = nearest_wall(*scene.room, Vec2(luminaire.position));
    return wall.distance - reach_along(scene, luminaire, Vec3(wall.inward, 0.0)) < nearly;
}

bool is_over_plan(const Room& room, const Vec2& place) {
    bool inside = false;
    for (std::size_t k = 0; k < room.plan.size(); ++k) {
        const Vec2 a = room.plan[k], b = room.plan[(k + 1) % room.plan.size()];
        if ((a.y > place.y) == (b.y > place.y)) continue;
        if (place.x < a.x + (place.y - a.y) / (b.y - a.y) * (b.x - a.x)) inside = !inside;
    }
    return inside;
}

}  // namespace hanei
