/// Cameras: from the room to the picture and back. z is up.
#pragma once

#include "engine/base/vector.h"
#include "engine/scene/faces.h"

#include <optional>
#include <string>

namespace hanei {

/// What of a room is not drawn (left_out.h says what follows from it).
struct LeftOut {
    bool ceiling = false;
    std::optional<Cut> cut{};
    bool operator==(const LeftOut&) const = default;
};

struct Camera {
    Vec3 eye{0.0};
    Vec3 target{0.0};
    double field_of_view = 0.9;  ///< rad, vertical
    bool orthographic = false;   ///< then the picture is as high as the field of view at the target
    LeftOut left_out{};
    bool operator==(const Camera&) const = default;
};

struct Ray {
    Vec3 origin{0.0};
    Vec3 direction{0.0, 0.0, -1.0};  ///< unit
    LeftOut left_out{};              ///< of the picture it looks through
};

/// The camera's own axes: a right-handed frame with `back` = right x up.
struct CameraAxes {
    Vec3 right{1.0, 0.0, 0.0};
    Vec3 up{0.0, 1.0, 0.0};
    Vec3 forward{0.0, 0.0, -1.0};
};
/// Up leans towards +z; looking straight up or down it is +y, so that plans have north at the top.
/// An orthographic camera that looks straight up gives a reflected ceiling plan, as a mirror on the
/// floor would show it: right is +x there too, so that it lies over the plan, and the frame is
/// left-handed.
CameraAxes axes_of(const Camera& camera);
bool is_mirrored(const Camera& camera);  ///< whether it is

Camera camera_of(const View& view);
View view_of(const Camera& camera, std::string name);

/// A three-quarter view from above that shows all of the bounds with a small margin, the longer
/// side of the plan across the picture: what a room opens with.
Camera overview(const Bounds& bounds, double aspect);
/// Straight down, orthographic, north (y) up.
Camera plan_view(const Bounds& bounds, double aspect);
/// Orthographic, from far out in this direction (unit).
Camera along_axis(const Vec3& from, const Bounds& bounds, double aspect);
/// Looks at the middle of the bounds, in its own direction, and shows all of them as large as it can.
Camera fitted(const Camera& camera, const Bounds& bounds, double aspect);
/// The other projection, with what is at the target as large as before.
Camera with_other_projection(const Camera& camera);

/// All take and give pictures positions as 0..1 from the top left; aspect is width / height.
Ray ray_through(const Camera& camera, Vec2 at, double aspect);
std::optional<Vec2> projected(const Camera& camera, const Vec3& place, double aspect);  ///< empty behind the eye

/// Metres that one picture height covers at a place (its distance along the line of sight).
double picture_height_at(const Camera& camera, const Vec3& place);

/// `by` is how far the pointer went, right and down: what lies near follows it.
Camera orbited(const Camera& camera, Vec2 by);                ///< rad, about the target; never over the pole
Camera panned(const Camera& camera, Vec2 by, double aspect);  ///< in picture heights
/// Things grow by `factor` (above 1: closer). What is under `at`, at the target's depth, stays there.
Camera zoomed(const Camera& camera, double factor, Vec2 at, double aspect);

/// Clip-space matrices for the renderer, near and far fitted to the bounds.
glm::dmat4 view_projection(const Camera& camera, double aspect, const Bounds& bounds);

}  // namespace hanei
