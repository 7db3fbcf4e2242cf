#include "engine/scene/intensity.h"

#include <cmath>
#include <numbers>

namespace hanei {
namespace {

constexpr double degrees = 180.0 / std::numbers::pi;

/// Latitude of a unit vector by its component along the axis and the other two: no accuracy is lost
/// near the poles, as arc sine would.
double latitude_deg(double along_axis, double across_1, double across_2) {
    return std::atan2(along_axis, std::hypot(across_1, across_2)) * degrees;
}

}  // namespace

PhotometricAngles photometric_angles(PhotometricType type, const Vec3& e) {
    switch (type) {
        case PhotometricType::A:
            return {std::atan2(-e.y, e.x) * degrees, latitude_deg(e.z, e.x, e.y)};
        case PhotometricType::B:
            return {latitude_deg(-e.y, e.x, e.z), std::atan2(e.x, -e.z) * degrees};
        case PhotometricType::C:
            break;
    }
    double plane = std::atan2(e.y, e.x) * degrees;
    if (plane < 0.0) plane += 360.0;
    return {plane < 360.0 ? plane : 0.0, std::atan2(std::hypot(e.x, e.y), -e.z) * degrees};
}

Vec3 photometric_direction(PhotometricType type, const PhotometricAngles& angles) {
    const double h = angles.horizontal_deg / degrees;
    const double v = angles.vertical_deg / degrees;
    switch (type) {
        case PhotometricType::A:
            return {std::cos(v) * std::cos(h), -std::cos(v) * std::sin(h), std::sin(v)};
        case PhotometricType::B:
            return {std::cos(h) * std::sin(v), -std::sin(h), -std::cos(h) * std::cos(v)};
        case PhotometricType::C:
            break;
    }
    return {std::sin(v) * std::cos(h), std::sin(v) * std::sin(h), -std::cos(v)};
}

}  // namespace hanei
