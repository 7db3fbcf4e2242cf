#include "ui/view/camera_passage.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace hanei {
namespace {

constexpr double nearly_parallel = 0.01;  // half a picture height over its distance: a lens of 1.1 degrees
constexpr double pole_margin = 0.01;      // rad that the way stays off the vertical
constexpr double upright_slack = 1e-6;    // of the distance: less aside is straight up or down

/// Where the eye is, as seen from the target.
struct Direction {
    double azimuth = 0.0, elevation = 0.0;
};

/// Straight up or down, the azimuth under which the picture's upper edge is that of a plan.
Direction direction_to_eye(const Camera& camera) {
    const Vec3 offset = camera.eye - camera.target;
    const double level = std::hypot(offset.x, offset.y);
    const bool vertical = level <= upright_slack * glm::length(offset);
    constexpr double quarter = 0.5 * std::numbers::pi;
    return {vertical ? std::copysign(quarter, -offset.z) : std::atan2(offset.y, offset.x), std::atan2(offset.z, level)};
}

double slope_of(const Camera& camera) {
    return camera.orthographic ? nearly_parallel : std::tan(0.5 * camera.field_of_view);
}

double along(double from, double to, double share) { return from + share * (to - from); }

/// From one positive length to another by equal factors.
double by_factors(double from, double to, double share) { return from * std::pow(to / from, share); }

}  // namespace

bool can_glide(const Camera& from, const Camera& to) {
    const auto has_height = [](const Camera& camera) {
        const double height = picture_height_at(camera, camera.target);
        return std::isfinite(height) && height > 0.0;
    };
    return has_height(from) && has_height(to) && !is_mirrored(from) && !is_mirrored(to);
}

Camera between(const Camera& from, const Camera& to, double share) {
    if (!(share < 1.0)) return to;
    const Direction first = direction_to_eye(from), last = direction_to_eye(to);
    const double azimuth = first.azimuth + share * std::remainder(last.azimuth - first.azimuth, 2.0 * std::numbers::pi);
    const double limit = 0.5 * std::numbers::pi - pole_margin;
    const double elevation = std::clamp(along(first.elevation, last.elevation, share), -limit, limit);
    const double height = by_factors(picture_height_at(from, from.target), picture_height_at(to, to.target), share);
    Camera camera = to;
    camera.orthographic = from.orthographic && to.orthographic;
    const double slope =
        camera.orthographic ? std::tan(0.5 * to.field_of_view) : by_factors(slope_of(from), slope_of(to), share);
    camera.field_of_view = 2.0 * std::atan(slope);
    camera.target = from.target + share * (to.target - from.target);
    const double level = std::cos(elevation);
    camera.eye = camera.target +
                 0.5 * height / slope * Vec3(level * std::cos(azimuth), level * std::sin(azimuth), std::sin(elevation));
    return camera;
}

}  // namespace hanei
