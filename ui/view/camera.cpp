#include "ui/view/camera.h"

#include <glm/gtc/matrix_transform.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace hanei {
namespace {

constexpr double overview_field_of_view = 0.55;  // rad: a long lens, so that walls stay nearly upright
constexpr double overview_azimuth = 0.46;        // rad, from the normal of the longer side
constexpr double overview_elevation = 0.64;      // rad: floor, two walls and the desks' tops all show
constexpr double fit_margin = 0.93;              // share of the picture that the bounds may fill
constexpr double pole_margin = 0.01;             // rad that orbiting stays away from straight down
constexpr double upright_slack = 1e-6;           // rad from the vertical: less is straight up or down
constexpr double nearest_share = 1e-3;           // of the scene: nothing nearer to the eye is drawn

std::array<Vec3, 8> corners_of(const Bounds& bounds) {
    std::array<Vec3, 8> corners;
    for (int k = 0; k < 8; ++k) {
        corners[static_cast<std::size_t>(k)] = {(k & 1) != 0 ? bounds.high.x : bounds.low.x,
                                                (k & 2) != 0 ? bounds.high.y : bounds.low.y,
                                                (k & 4) != 0 ? bounds.high.z : bounds.low.z};
    }
    return corners;
}

double half_height(const Camera& camera) { return std::tan(0.5 * camera.field_of_view); }

double distance_to_target(const Camera& camera) { return glm::length(camera.target - camera.eye); }

Vec3 from_target(double azimuth, double elevation) {
    return {std::cos(elevation) * std::cos(azimuth), std::cos(elevation) * std::sin(azimuth), std::sin(elevation)};
}

struct Extent {
    Vec2 low{1e300}, high{-1e300};
};

Extent projected_extent(const Camera& camera, const Bounds& bounds, double aspect) {
    Extent extent;
    for (const Vec3& corner : corners_of(bounds)) {
        const Vec2 at = projected(camera, corner, aspect).value_or(Vec2(0.5));
        extent.low = glm::min(extent.low, at);
        extent.high = glm::max(extent.high, at);
    }
    return extent;
}

/// Moves back and sideways until the bounds fill the picture; the direction of view stays.
Camera fitted_from_afar(Camera camera, const Bounds& bounds, double aspect) {
    for (int round = 0; round < 12; ++round) {
        const Extent extent = projected_extent(camera, bounds, aspect);
        const Vec2 size = extent.high - extent.low;
        const Vec2 off_centre = 0.5 * (extent.high + extent.low) - Vec2(0.5);
        camera = panned(camera, Vec2(-off_centre.x * aspect, -off_centre.y), aspect);
        const double filled = std::max(size.x, size.y) / fit_margin;
        camera.eye = camera.target + (camera.eye - camera.target) * filled;
    }
    return camera;
}

Bounds with_some_size(Bounds bounds) {
    if (!(bounds.diameter() > 1e-6)) return {bounds.low - Vec3(1.0), bounds.low + Vec3(1.0)};
    return bounds;
}

}  // namespace

CameraAxes axes_of(const Camera& camera) {
    const Vec3 towards = camera.target - camera.eye;
    const double distance = glm::length(towards);
    CameraAxes axes;
    axes.forward = distance > 0.0 ? towards / distance : Vec3(0.0, 0.0, -1.0);
    const bool upright = std::hypot(axes.forward.x, axes.forward.y) > upright_slack;
    axes.right = glm::normalize(glm::cross(axes.forward, upright ? Vec3(0.0, 0.0, 1.0) : Vec3(0.0, 1.0, 0.0)));
    axes.up = glm::cross(axes.right, axes.forward);
    if (is_mirrored(camera)) axes.right = -axes.right;
    return axes;
}

bool is_mirrored(const Camera& camera) {
    const Vec3 towards = camera.target - camera.eye;
    return camera.orthographic && towards.z > 0.0 && std::hypot(towards.x, towards.y) <= upright_slack * towards.z;
}

Camera camera_of(const View& view) {
    return {view.eye, view.target, view.field_of_view, view.orthographic, {view.hides_ceiling, view.cut}};
}

View view_of(const Camera& camera, std::string name) {
    View view;
    view.name = std::move(name);
    view.eye = camera.eye;
    view.target = camera.target;
    view.field_of_view = camera.field_of_view;
    view.orthographic = camera.orthographic;
    view.hides_ceiling = camera.left_out.ceiling;
    view.cut = camera.left_out.cut;
    return view;
}

Camera overview(const Bounds& authored, double aspect) {
    const Bounds bounds = with_some_size(authored);
    const Vec3 size = bounds.high - bounds.low;
    const bool long_in_x = size.x >= size.y;
    const double azimuth = long_in_x ? -0.5 * std::numbers::pi + overview_azimuth : -overview_azimuth;
    Camera camera;
    camera.field_of_view = overview_field_of_view;
    camera.target = 0.5 * (bounds.low + bounds.high);
    camera.eye = camera.target + 3.0 * bounds.diameter() * from_target(azimuth, overview_elevation);
    return fitted_from_afar(camera, bounds, aspect);
}

Camera plan_view(const Bounds& bounds, double aspect) { return along_axis({0.0, 0.0, 1.0}, bounds, aspect); }

Camera along_axis(const Vec3& from, const Bounds& authored, double aspect) {
    const Bounds bounds = with_some_size(authored);
    Camera camera;
    camera.orthographic = true;
    camera.field_of_view = overview_field_of_view;
    camera.target = 0.5 * (bounds.low + bounds.high);
    camera.eye = camera.target + 3.0 * bounds.diameter() * from;
    return fitted_from_afar(camera, bounds, aspect);
}

/// In the camera's own axes, every corner must lie between the picture's edges: from the eye they open
/// by a slope a side, so that the farthest corners along each edge's normal decide.
Camera fitted(const Camera& camera, const Bounds& authored, double aspect) {
    const Bounds bounds = with_some_size(authored);
    const CameraAxes axes = axes_of(camera);
    const Vec3 middle = 0.5 * (bounds.low + bounds.high);
    const double slope = fit_margin * half_height(camera);
    const Vec2 slopes(slope * aspect, slope);
    Vec2 low(-1e300), high(1e300), extent(0.0);  // where the edges meet depth 0; half sizes
    double nearest = 0.0;
    for (const Vec3& corner : corners_of(bounds)) {
        const Vec3 from = corner - middle;
        const Vec2 aside(glm::dot(from, axes.right), glm::dot(from, axes.up));
        const double depth = glm::dot(from, axes.forward);
        low = glm::max(low, aside - depth * slopes);
        high = glm::min(high, aside + depth * slopes);
        extent = glm::max(extent, glm::abs(aside));
        nearest = std::max(nearest, -depth);
    }
    Camera back = camera;
    Vec3 aside(0.0);
    double distance = std::max(extent.x / slopes.x, extent.y / slopes.y);
    if (!camera.orthographic) {
        const Vec2 depths = 0.5 * (high - low) / slopes;
        const Vec2 centre = 0.5 * (low + high);
        // The widest lenses could stand at the nearest corner itself.
        distance = std::max(-std::min(depths.x, depths.y), nearest + 0.15 * bounds.diameter());
        aside = centre.x * axes.right + centre.y * axes.up;
    }
    back.target = middle + aside;
    back.eye = back.target - distance * axes.forward;
    return back;
}

Camera with_other_projection(const Camera& camera) {
    Camera other = camera;
    other.orthographic = !camera.orthographic;
    return other;
}

Ray ray_through(const Camera& camera, Vec2 at, double aspect) {
    const CameraAxes axes = axes_of(camera);
    const double half = half_height(camera);
    const Vec3 aside = (2.0 * at.x - 1.0) * aspect * half * axes.right + (1.0 - 2.0 * at.y) * half * axes.up;
    if (camera.orthographic) return {camera.eye + aside * distance_to_target(camera), axes.forward, camera.left_out};
    return {camera.eye, glm::normalize(axes.forward + aside), camera.left_out};
}

std::optional<Vec2> projected(const Camera& camera, const Vec3& place, double aspect) {
    const CameraAxes axes = axes_of(camera);
    const Vec3 from_eye = place - camera.eye;
    const double depth = camera.orthographic ? distance_to_target(camera) : glm::dot(from_eye, axes.forward);
    if (!(depth > 0.0)) return std::nullopt;
    const double scale = depth * half_height(camera);
    return Vec2(0.5 + 0.5 * glm::dot(from_eye, axes.right) / (scale * aspect),
                0.5 - 0.5 * glm::dot(from_eye, axes.up) / scale);
}

double picture_height_at(const Camera& camera, const Vec3& place) {
    const double depth = camera.orthographic ? distance_to_target(camera)
                                             : std::max(0.0, glm::dot(place - camera.eye, axes_of(camera).forward));
    return 2.0 * depth * half_height(camera);
}

Camera orbited(const Camera& camera, Vec2 by) {
    const Vec3 offset = camera.eye - camera.target;
    const double distance = glm::length(offset);
    if (!(distance > 0.0)) return camera;
    const double level = std::hypot(offset.x, offset.y);
    const double azimuth = level > 1e-6 * distance ? std::atan2(offset.y, offset.x) : -0.5 * std::numbers::pi;
    const double limit = 0.5 * std::numbers::pi - pole_margin;
    const double elevation = std::clamp(std::atan2(offset.z, level) + by.y, -limit, limit);
    Camera turned = camera;
    turned.eye = camera.target + distance * from_target(azimuth - by.x, elevation);
    return turned;
}

Camera panned(const Camera& camera, Vec2 by, double /*aspect*/) {
    const CameraAxes axes = axes_of(camera);
    const Vec3 shift = (axes.up * by.y - axes.right * by.x) * picture_height_at(camera, camera.target);
    Camera moved = camera;
    moved.eye += shift;
    moved.target += shift;
    return moved;
}

Camera zoomed(const Camera& camera, double factor, Vec2 at, double aspect) {
    if (!(factor > 0.0)) return camera;
    const Ray ray = ray_through(camera, at, aspect);
    const CameraAxes axes = axes_of(camera);
    const double depth = glm::dot(camera.target - ray.origin, axes.forward) / glm::dot(ray.direction, axes.forward);
    const Vec3 fixed = ray.origin + depth * ray.direction;
    Camera closer = camera;
    closer.eye = fixed + (camera.eye - fixed) / factor;
    closer.target = fixed + (camera.target - fixed) / factor;
    return closer;
}

glm::dmat4 view_projection(const Camera& camera, double aspect, const Bounds& authored) {
    const Bounds bounds = with_some_size(authored);
    const CameraAxes axes = axes_of(camera);
    const double size = bounds.diameter();
    double near_depth = 1e300, far_depth = -1e300;
    for (const Vec3& corner : corners_of(bounds)) {
        const double depth = glm::dot(corner - camera.eye, axes.forward);
        near_depth = std::min(near_depth, depth);
        far_depth = std::max(far_depth, depth);
    }
    near_depth -= 0.02 * size;
    far_depth = std::max(far_depth + 0.02 * size, near_depth + size);
    glm::dmat4 view = glm::lookAt(camera.eye, camera.eye + axes.forward, axes.up);
    if (is_mirrored(camera)) view = glm::scale(glm::dmat4(1.0), Vec3(-1.0, 1.0, 1.0)) * view;
    const double half = half_height(camera);
    if (camera.orthographic) {
        const double height = half * distance_to_target(camera);
        return glm::ortho(-height * aspect, height * aspect, -height, height, near_depth, far_depth) * view;
    }
    near_depth = std::max(near_depth, nearest_share * size);
    far_depth = std::max(far_depth, 2.0 * near_depth);
    return glm::perspective(camera.field_of_view, aspect, near_depth, far_depth) * view;
}

}  // namespace hanei
