/// Cameras: from the room to the picture and back. z is up.
#pragma once

#include "engine/base/vector.h"
#include "engine/scene/faces.h"

#include <optional>

namespace hanei {

struct Camera {
    Vec3 eye{0.0};
    Vec3 target{0.0};
    double field_of_view = 0.9;  ///< rad, vertical
    bool orthographic = false;
    bool operator==(const Camera&) const = default;
};

struct Ray {
    Vec3 origin{0.0};
    Vec3 direction{0.0, 0.0, -1.0};  ///< unit
};

Camera camera_of(const View& view);
View view_of(const Camera& camera, std::string name);

/// A three-quarter view from above that shows all of the bounds: what a room opens with.
Camera overview(const Bounds& bounds, double aspect);
/// Straight down, orthographic, north (y) up.
Camera plan_view(const Bounds& bounds, double aspect);

/// All take and give pictures positions as 0..1 from the top left; aspect is width / height.
Ray ray_through(const Camera& camera, Vec2 at, double aspect);
std::optional<Vec2> projected(const Camera& camera, const Vec3& place, double aspect);  ///< empty behind the eye

Camera orbited(const Camera& camera, Vec2 by);                        ///< rad, about the target; never over the pole
Camera panned(const Camera& camera, Vec2 by, double aspect);          ///< in picture heights
Camera zoomed(const Camera& camera, double factor, Vec2 at, double aspect);  ///< towards what is under `at`

/// Clip-space matrices for the renderer, near and far fitted to the bounds.
glm::dmat4 view_projection(const Camera& camera, double aspect, const Bounds& bounds);

}  // namespace hanei
