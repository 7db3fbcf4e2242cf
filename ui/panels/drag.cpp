#include "ui/panels/drag.h"

#include <cmath>

namespace hanei {
namespace {

constexpr double horizon_sine = 0.05;  // sin 3 degrees: a plane seen flatter than this is seen end on

}  // namespace

Vec3 direction_of(Axis axis) {
    return {axis == Axis::x ? 1.0 : 0.0, axis == Axis::y ? 1.0 : 0.0, axis == Axis::z ? 1.0 : 0.0};
}

std::optional<Vec3> on_horizontal_plane(const Ray& ray, double height, double reach) {
    if (std::abs(ray.direction.z) < horizon_sine) return std::nullopt;
    const double distance = (height - ray.origin.z) / ray.direction.z;
    if (distance < 0.0) return std::nullopt;
    const Vec3 place = ray.origin + distance * ray.direction;
    if (distance > reach) return std::nullopt;
    return place;
}

std::optional<double> along_axis(const Ray& ray, const Vec3& origin, Axis axis) {
    const Vec3 line = direction_of(axis);
    const double cosine = glm::dot(ray.direction, line);
    const double sine_squared = 1.0 - cosine * cosine;
    if (sine_squared < horizon_sine * horizon_sine) return std::nullopt;
    const Vec3 between = origin - ray.origin;
    return (cosine * glm::dot(ray.direction, between) - glm::dot(line, between)) / sine_squared;
}

double snapped(double value, double raster) { return raster > 0.0 ? std::round(value / raster) * raster : value; }

}  // namespace hanei
