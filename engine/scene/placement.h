/// Where authored objects stand in the room: from their own frames to the scene's.
#pragma once

#include "engine/scene/scene.h"

namespace hanei {

/// x_scene = rotation * x_local + position. The rotation of an unturned object is exactly 1.
struct Placement {
    Mat3 rotation{1.0};
    Vec3 position{0.0};

    Vec3 point(const Vec3& local) const { return rotation * local + position; }
    Vec3 direction(const Vec3& local) const { return rotation * local; }
    Region region(const Region& local) const;
};

Placement placement(const Furniture& furniture);
Placement placement(const Furniture& furniture, const Part& part);
/// Rz(yaw) Ry(-tilt) Rx(roll): yaw first as the user sees it, tilt towards C0, then roll.
Placement placement(const Luminaire& luminaire);

/// Angle between a luminaire's own vertical and the room's, rad.
double tilt_from_vertical(const Luminaire& luminaire);

}  // namespace hanei
