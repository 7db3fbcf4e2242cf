#include "engine/scene/placement.h"

#include <cmath>

namespace hanei {
namespace {

struct Turn {
    double cosine = 1.0;
    double sine = 0.0;
};

/// A quarter turn typed in degrees arrives as the double nearest to pi/2, whose cosine is 6e-17: what
/// is smaller than rounding makes it is taken as exactly 0, so that walls stay parallel to axes.
Turn turn(double angle) {
    constexpr double rounding = 4e-16;  // of a whole turn in radians, the greatest angle users type
    Turn result{std::cos(angle), std::sin(angle)};
    if (std::abs(result.cosine) < rounding) result = {0.0, result.sine > 0.0 ? 1.0 : -1.0};
    if (std::abs(result.sine) < rounding) result = {result.cosine > 0.0 ? 1.0 : -1.0, 0.0};
    return result;
}

// GLM's matrices are written column by column: each row below is the image of an axis.

Mat3 about_x(double angle) {
    const auto [c, s] = turn(angle);
    return {{1.0, 0.0, 0.0}, {0.0, c, s}, {0.0, -s, c}};
}

Mat3 about_y(double angle) {
    const auto [c, s] = turn(angle);
    return {{c, 0.0, -s}, {0.0, 1.0, 0.0}, {s, 0.0, c}};
}

Mat3 about_z(double angle) {
    const auto [c, s] = turn(angle);
    return {{c, s, 0.0}, {-s, c, 0.0}, {0.0, 0.0, 1.0}};
}

}  // namespace

Region Placement::region(const Region& local) const {
    Region placed = local;
    for (Vec3& corner : placed.outline) corner = point(corner);
    for (Polygon& hole : placed.holes) {
        for (Vec3& corner : hole) corner = point(corner);
    }
    return placed;
}

Placement placement(const Furniture& furniture) { return {about_z(furniture.rotation), furniture.position}; }

Placement placement(const Furniture& furniture, const Part& part) {
    const Placement whole = placement(furniture);
    return {whole.rotation * about_z(part.rotation), whole.point(part.position)};
}

double tilt_from_vertical(const Luminaire& luminaire) {
    const Vec3 up = placement(luminaire).rotation[2];
    return std::atan2(std::sqrt(up.x * up.x + up.y * up.y), up.z);
}

Placement placement(const Luminaire& luminaire) {
    return {about_z(luminaire.yaw) * about_y(-luminaire.tilt) * about_x(luminaire.roll), luminaire.position};
}

}  // namespace hanei
