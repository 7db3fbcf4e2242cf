#include "ui/panels/walking.h"

#include "engine/edit/hanging.h"
#include "engine/edit/plan_shape.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace hanei {
namespace {

constexpr double shoulder = 0.25;     // m to walls
constexpr double longest_part = 0.1;  // m of a step that is taken at once: no wall is stepped over
constexpr double head_room = 0.1;     // m between eye and ceiling
constexpr double most_pitch = 1.4;    // rad: straight up and down have no heading
constexpr double target_ahead = 2.0;  // m: what the view turns about when the walk is over

Vec2 nearest_on(const Vec2& a, const Vec2& b, const Vec2& place) {
    const Vec2 along = b - a;
    const double squared = glm::dot(along, along);
    const double share = squared > 0.0 ? std::clamp(glm::dot(place - a, along) / squared, 0.0, 1.0) : 0.0;
    return a + share * along;
}

double distance_to_walls(const std::vector<Vec2>& plan, const Vec2& place) {
    double least = 1e300;
    for (std::size_t k = 0; k < plan.size(); ++k)
        least = std::min(least, glm::distance(place, nearest_on(plan[k], plan[(k + 1) % plan.size()], place)));
    return least;
}

/// Pushed off every wall that is nearer than this, towards the room.
Vec2 kept_off(const std::vector<Vec2>& plan, Vec2 place, double clear) {
    constexpr int rounds = 4;  // a corner takes two
    for (int round = 0; round < rounds; ++round) {
        for (std::size_t k = 0; k < plan.size(); ++k) {
            const Vec2 a = plan[k], b = plan[(k + 1) % plan.size()];
            const Vec2 along = b - a, foot = nearest_on(a, b, place);
            const double length = glm::length(along), away = glm::distance(place, foot);
            const bool at_end = foot == a || foot == b;
            if (!(length > 0.0)) continue;
            const Vec2 inward = Vec2(-along.y, along.x) / length;  // plans run counter-clockwise
            const double depth = at_end ? away : glm::dot(place - foot, inward);
            if (depth >= clear || away >= 2.0 * longest_part + clear) continue;
            place = foot + clear * (at_end && away > 0.0 ? (place - foot) / away : inward);
        }
    }
    return place;
}

bool allows(const std::vector<Vec2>& plan, const Vec2& place, double clear) {
    return plan_holds(plan, place) && distance_to_walls(plan, place) >= clear - 1e-6;
}

}  // namespace

void Walker::turn(double heading_by, double pitch_by) {
    heading = std::remainder(heading + heading_by, 2.0 * std::numbers::pi);
    pitch = std::clamp(pitch + pitch_by, -most_pitch, most_pitch);
}

Walker walker_of(const Camera& camera) {
    const Vec3 gaze = axes_of(camera).forward, up = axes_of(camera).up;
    const double level = std::hypot(gaze.x, gaze.y);
    Walker walker;
    walker.eye = camera.eye;
    walker.heading = level > 1e-6 ? std::atan2(gaze.y, gaze.x) : std::atan2(up.y, up.x);
    walker.turn(0.0, std::atan2(gaze.z, level));
    return walker;
}

Camera seen_by(const Walker& walker, const Camera& camera) {
    Camera seen = camera;
    seen.orthographic = false;
    seen.eye = walker.eye;
    const double level = std::cos(walker.pitch);
    seen.target = seen.eye + target_ahead * Vec3(level * std::cos(walker.heading), level * std::sin(walker.heading),
                                                 std::sin(walker.pitch));
    return seen;
}

double floor_of(const Scene& scene) { return scene.room ? scene.room->floor_height : bounds_of(scene).low.z; }

EyeHeights eye_heights(const Scene& scene) {
    EyeHeights heights;
    if (!scene.room) return heights;
    heights.high = std::max(0.5 * scene.room->height, scene.room->height - head_room);
    heights.low = std::min(heights.low, heights.high);
    return heights;
}

Step stepped(const Scene& scene, const Vec2& from, const Vec2& by) {
    const double length = glm::length(by);
    if (!std::isfinite(length) || !(length > 0.0)) return {from, false};
    if (!scene.room || !plan_holds(scene.room->plan, from)) return {from + by, false};
    const std::vector<Vec2>& plan = scene.room->plan;
    const double clear = std::min(shoulder, distance_to_walls(plan, from));
    const int parts = std::clamp(static_cast<int>(std::ceil(length / longest_part)), 1, 1000);
    const Vec2 part = std::min(1.0, 1000.0 * longest_part / length) * by / static_cast<double>(parts);
    Vec2 at = from;
    for (int k = 0; k < parts; ++k) {
        const Vec2 next = kept_off(plan, at + part, clear);
        if (!allows(plan, next, clear)) break;
        at = next;
    }
    return {at, glm::distance(at, from) < 0.5 * length};
}

Walker entering(const Scene& scene, const Camera& camera) {
    Walker walker = walker_of(camera);
    walker.eye.z = floor_of(scene) + eye_heights(scene).kept(usual_eye_height);
    if (!scene.room || scene.room->plan.size() < 3) return walker;
    const Room& room = *scene.room;
    const Vec2 place(camera.eye);
    const bool is_inside = !camera.orthographic && plan_holds(room.plan, place) && camera.eye.z > room.floor_height &&
                           camera.eye.z < room.floor_height + room.height;
    if (is_inside) return walker;
    // Of places over the whole plan that are clear of walls, the one nearest to the eye.
    const PlanBounds bounds = bounds_of_plan(scene);
    const Vec2 middle = middle_of_plan(room.plan);
    Vec2 best = middle;
    double least = 1e300;
    constexpr int places = 40;  // each way
    for (const double clear : {3.0 * shoulder, shoulder, 0.0}) {
        for (int k = 0; k < places * places; ++k) {
            const Vec2 share((k % places + 0.5) / places, (k / places + 0.5) / places);
            const Vec2 each = bounds.low + share * (bounds.high - bounds.low);
            const double away = glm::distance(each, place);
            if (away >= least || !allows(room.plan, each, clear)) continue;
            least = away;
            best = each;
        }
        if (least < 1e300) break;
    }
    walker.eye = Vec3(best, walker.eye.z);
    const Vec2 ahead = middle - best;
    if (glm::length(ahead) > 0.0) walker.heading = std::atan2(ahead.y, ahead.x);
    walker.pitch = 0.0;
    return walker;
}

}  // namespace hanei
