/// Changes to the room's plan. Sub-areas stay where they are in the room as far as their walls do: they
/// slide along them, shrink with them, and go when their wall goes.
#pragma once

#include "engine/edit/edit.h"
#include "engine/edit/reflectances.h"

#include <string>

namespace hanei {

struct PlanEdit {
    std::optional<Scene> scene;  ///< nothing when the change makes no room
    std::string message;         ///< why not; or what went with it ("Window 2 went with its wall")
};

/// Corner k at another place.
PlanEdit with_corner_moved(const Scene& scene, std::size_t corner, const Vec2& to);
/// Wall k shifted by `by` m at right angles, into the room where negative; its neighbours keep their directions
/// when they meet it at more than 20 degrees.
PlanEdit with_wall_moved(const Scene& scene, std::size_t wall, double by);
/// A corner within wall k: two walls of the same material.
PlanEdit with_corner_inserted(const Scene& scene, std::size_t wall, const Vec2& at);
PlanEdit with_corner_removed(const Scene& scene, std::size_t corner);
/// Wall k of this length: its end moves, and the wall after it with it, so that right angles stay.
PlanEdit with_wall_length(const Scene& scene, std::size_t wall, double length);
/// Another plan altogether, in whatever order its corners run; a room is made when there is none. Every new
/// wall has the material of the first old one; sub-areas of walls go.
PlanEdit with_plan(const Scene& scene, const std::vector<Vec2>& plan);

/// What a new project begins with.
struct NewRoom {
    std::string shape = "box";  ///< usual_plan(): box, L, T, U
    double length = 6.0, width = 4.0, height = 2.8, floor_height = 0.0;
    Reflectances reflectances;
    bool operator==(const NewRoom&) const = default;
};
Scene new_room(const NewRoom& wished);

}  // namespace hanei
