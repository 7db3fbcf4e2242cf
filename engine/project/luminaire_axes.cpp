#include "engine/project/luminaire_axes.h"

#include <cmath>

namespace hanei {

void aim(Luminaire& luminaire, const Vec3& nadir, const Vec3& c0) {
    const Vec3 up = -glm::normalize(nadir);
    const Vec3 x = glm::normalize(c0 - glm::dot(c0, up) * up);
    const Vec3 y = glm::cross(up, x);
    constexpr double upright = 1e-12;  // x this close to the vertical has no bearing but rounding
    const double level = std::hypot(x.x, x.y);
    luminaire.tilt = std::atan2(x.z, level);
    luminaire.yaw = level < upright ? 0.0 : std::atan2(x.y, x.x);
    const Vec3 y_before_roll{-std::sin(luminaire.yaw), std::cos(luminaire.yaw), 0.0};
    luminaire.roll = std::atan2(-glm::dot(up, y_before_roll), glm::dot(y, y_before_roll));
}

Vec3 any_c0(const Vec3& nadir) {
    const Vec3 down = glm::normalize(nadir);
    const Vec3 start = std::abs(down.x) < 0.9 ? Vec3{1.0, 0.0, 0.0} : Vec3{0.0, 1.0, 0.0};
    return glm::normalize(start - glm::dot(start, down) * down);
}

}  // namespace hanei
