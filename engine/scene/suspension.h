/// How luminaires are held: the size of their openings, and the ceiling above them.
#pragma once

#include "engine/scene/scene.h"

#include <optional>
#include <utility>

namespace hanei {

/// Half the extents of the luminous opening about the luminaire's place, in its own frame, m; 0 for a
/// point. Of an opening that does not lie about its place, the farthest it reaches each way.
Vec3 half_extent(const Scene& scene, const Luminaire& luminaire);

/// How far the opening reaches above its place as it is turned, m.
double reach_upward(const Scene& scene, const Luminaire& luminaire);
/// How far it reaches along a unit direction of the scene.
double reach_along(const Scene& scene, const Luminaire& luminaire, const Vec3& direction);

/// Between the ceiling and the top of an opening that hangs nearer than this it has no suspension, m.
inline constexpr double shortest_suspension = 0.12;

/// The wall nearest to a place of the plan.
struct WallFoot {
    Vec2 foot{0.0};
    Vec2 inward{1.0, 0.0};  ///< unit, into the room
    double distance = 0.0;  ///< m; infinite without walls
};
WallFoot nearest_wall(const Room& room, const Vec2& place);

/// Its opening reaches nearly to a wall.
bool hangs_on_wall(const Scene& scene, const Luminaire& luminaire);

/// What a pendant luminaire hangs by: from the top of its opening straight up to the ceiling. Empty
/// without a room, outside its plan, close to the ceiling, on a wall, and in the room's lower
/// half, where luminaires stand.
std::optional<std::pair<Vec3, Vec3>> suspension_of(const Scene& scene, const Luminaire& luminaire);

/// In the plan of the room, its border not counted; false without a room.
bool is_over_plan(const Room& room, const Vec2& place);

}  // namespace hanei
