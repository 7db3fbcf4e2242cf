#include "ui/panels/hanging.h"

#include "engine/edit/hanging.h"
#include "ui/panels/drag.h"
#include "ui/view/pick.h"

namespace hanei {
namespace {

constexpr double off_the_wall = 0.3;     // m, from a wall or cabinet that is pointed at
constexpr double within_the_room = 0.1;  // m

}  // namespace

Vec2 place_in_plan(const Scene& scene, const std::optional<Ray>& ray, double raster) {
    const PlanBounds plan = bounds_of_plan(scene);
    const std::optional<FaceHit> met = ray ? first_face(scene, *ray) : std::nullopt;
    Vec2 place = met ? Vec2(met->place) + off_the_wall * Vec2(met->normal) : plan.middle();
    place = {snapped(place.x, raster), snapped(place.y, raster)};
    const Vec2 margin = glm::min(Vec2(within_the_room), 0.5 * (plan.high - plan.low));
    return glm::clamp(place, plan.low + margin, plan.high - margin);
}

}  // namespace hanei
