#include "engine/base/tolerance.h"
#include "engine/geometry/polygon.h"
#include "engine/scene/faces.h"
#include "engine/scene/scene_findings.h"

#include <algorithm>
#include <cmath>

namespace hanei {
namespace {

Bounds bounds_of_plan(const std::vector<Vec2>& plan) {
    Bounds bounds{{plan[0], 0.0}, {plan[0], 0.0}};
    for (const Vec2& corner : plan) {
        bounds.low = glm::min(bounds.low, Vec3{corner, 0.0});
        bounds.high = glm::max(bounds.high, Vec3{corner, 0.0});
    }
    return bounds;
}

bool check_plan(ObjectFindings& object, const Room& room) {
    for (const Vec2& corner : room.plan)
        if (!object.finite("plan", {corner.x, corner.y})) return false;
    if (room.plan.size() < 3) {
        object.error("plan", "the plan has " + std::to_string(room.plan.size()) + " corners, at least 3 are needed");
        return false;
    }
    const double extent = bounds_of_plan(room.plan).diameter();
    const double area = signed_area(room.plan);
    if (!is_simple(room.plan)) {
        object.error("plan", "its edges cross or touch each other, or a corner stands twice; draw a simple outline");
    } else if (std::abs(area) <= tolerance::no_area * extent * extent) {
        object.error("plan", "the plan has no area; its corners lie on one line");
    } else if (area < 0.0) {
        object.error("plan", "the corners run clockwise; list them counter-clockwise seen from above");
    } else {
        return true;
    }
    return false;
}

/// Width and height of a room face in the coordinates of its sub-areas.
void check_inside_face(ObjectFindings& object, const Room& room, const SubArea& area) {
    Vec2 low{0.0};
    Vec2 high{0.0};
    if (area.face >= Room::wall_face(0)) {
        const auto k = static_cast<std::size_t>(area.face - Room::wall_face(0));
        high = {glm::distance(room.plan[k], room.plan[(k + 1) % room.plan.size()]), room.height};
    } else {
        const Bounds bounds = bounds_of_plan(room.plan);
        low = Vec2{bounds.low};
        high = Vec2{bounds.high};
    }
    const double thickness = tolerance::planar * glm::length(high - low);
    if (area.low.x < low.x - thickness || area.low.y < low.y - thickness || area.high.x > high.x + thickness ||
        area.high.y > high.y + thickness)
        object.warn("high", "it reaches past its face, which spans " + figure(low.x) + " to " + figure(high.x) +
                                " and " + figure(low.y) + " to " + figure(high.y) + "; what lies outside is not seen");
}

void check_sub_area(SceneChecks& checks, const Room& room, std::size_t index, bool plan_is_sound) {
    const SubArea& area = room.sub_areas[index];
    ObjectFindings object = checks.about("room.sub_areas", index, "sub-area", area.name, area.id);
    checks.check_id(object, area.id);
    checks.check_material(object, "material", area.material);
    const bool placed =
        object.finite("low", {area.low.x, area.low.y}) && object.finite("high", {area.high.x, area.high.y});
    const int faces = Room::wall_face(static_cast<int>(room.plan.size()));
    if (area.face < 0 || area.face >= faces) {
        object.error("face",
                     "the room has no such wall; there are " + std::to_string(room.plan.size()) + ", counted from 0");
    } else if (placed && !(area.low.x < area.high.x && area.low.y < area.high.y)) {
        object.error("high", "it has no area; \"high\" must be greater than \"low\" in both coordinates");
    } else if (placed && plan_is_sound) {
        check_inside_face(object, room, area);
    }
}

double reflectance_of(const Scene& scene, ObjectId id) {
    const Material* const material = find_material(scene, id);
    return material == nullptr ? 0.0 : material->reflectance;
}

/// Light that nothing absorbs never fades.
void check_absorption(SceneChecks& checks, ObjectFindings& object, const Room& room) {
    std::vector<ObjectId> used = room.wall_materials;
    used.insert(used.end(), {room.floor_material, room.ceiling_material});
    const bool all =
        std::all_of(used.begin(), used.end(), [&](ObjectId id) { return reflectance_of(checks.scene, id) == 1.0; });
    if (all)
        object.warn("walls",
                    "floor, ceiling and all walls reflect all light (reflectance 1): interreflection in the "
                    "closed room never ends; lower one of them");
}

}  // namespace

void check_room(SceneChecks& checks) {
    if (!checks.scene.room.has_value()) return;
    const Room& room = *checks.scene.room;
    ObjectFindings object(checks.findings, "room", "room", room.name, room.id);
    checks.check_id(object, room.id);
    const bool plan_is_sound = check_plan(object, room);
    object.finite("floor_height", {room.floor_height});
    object.positive("height", room.height);
    checks.check_material(object, "floor", room.floor_material);
    checks.check_material(object, "ceiling", room.ceiling_material);
    for (std::size_t k = 0; k < room.wall_materials.size(); ++k)
        checks.check_material(object, "walls[" + std::to_string(k) + ']', room.wall_materials[k]);
    if (room.wall_materials.size() != room.plan.size())
        object.error("walls", "found " + std::to_string(room.wall_materials.size()) + " materials for " +
                                  std::to_string(room.plan.size()) + " walls; one a plan edge is needed");
    for (std::size_t i = 0; i < room.sub_areas.size(); ++i) check_sub_area(checks, room, i, plan_is_sound);
    check_absorption(checks, object, room);
}

}  // namespace hanei
