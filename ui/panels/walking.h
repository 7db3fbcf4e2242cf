/// Steps of a person through the room: where the eye goes, and what walls allow.
#pragma once

#include "engine/scene/scene.h"
#include "ui/view/camera.h"

namespace hanei {

/// Somebody who stands in the room and looks around.
struct Walker {
    Vec3 eye{0.0};
    double heading = 0.0;  ///< rad, counter-clockwise from +x: where the person faces
    double pitch = 0.0;    ///< rad above the horizon, short of straight up and down

    void turn(double heading_by, double pitch_by);
};

Walker walker_of(const Camera& camera);
/// In perspective, from the walker's eye; the field of view and what is left out stay.
Camera seen_by(const Walker& walker, const Camera& camera);

constexpr double usual_eye_height = 1.6;  ///< m above the floor: of somebody who stands

/// Eye heights that this room allows, m above its floor: 0.3 to just under the ceiling, 3 m without a room.
struct EyeHeights {
    double low = 0.3, high = 3.0;
    double kept(double height) const { return height < low ? low : height > high ? high : height; }
};
EyeHeights eye_heights(const Scene& scene);
double floor_of(const Scene& scene);  ///< m, z

struct Step {
    Vec2 place{0.0};
    bool is_held = false;  ///< walls took more than half of the step
};

/// A step over the floor: along a wall that is in the way, a shoulder's breadth off it, or as near as
/// the step began. From outside of the plan, and without a room, it goes as it is wished. Furniture is
/// walked through.
/// Cost      linear in the plan's edges, for every 10 cm.
Step stepped(const Scene& scene, const Vec2& from, const Vec2& by);

/// Whoever is in the room looks on from there, upright; whoever is outside enters at the place nearest to
/// the eye and faces the middle. In both cases eyes are at the usual height.
Walker entering(const Scene& scene, const Camera& camera);

}  // namespace hanei
