#include "engine/mesh/patch_count.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace hanei {

namespace {

Vec2 sides_of(const Face& face) {
    const Vec3 across = glm::cross(face.normal, face.along);
    Vec2 low(std::numeric_limits<double>::infinity()), high = -low;
    for (const Vec3& corner : face.region.outline) {
        const Vec2 flat(glm::dot(corner, face.along), glm::dot(corner, across));
        low = glm::min(low, flat);
        high = glm::max(high, flat);
    }
    return glm::max(high - low, Vec2(0.0));
}

}  // namespace

double patch_count(std::span<const Face> faces, double max_patch) {
    double count = 0.0;
    for (const Face& face : faces) {
        const Vec2 along = glm::max(glm::floor(sides_of(face) / max_patch + 0.5), Vec2(1.0));
        count += along.x * along.y;
    }
    return count;
}

double width_for(std::span<const Face> faces, double wished, double most) {
    if (patch_count(faces, wished) <= most) return wished;
    double widest = wished;
    for (const Face& face : faces) widest = std::max({widest, 2.0 * sides_of(face).x, 2.0 * sides_of(face).y});
    constexpr int halvings = 60;
    double low = wished, high = widest;
    for (int k = 0; k < halvings; ++k) {
        const double middle = std::sqrt(low) * std::sqrt(high);
        (patch_count(faces, middle) <= most ? high : low) = middle;
    }
    return high;
}

}  // namespace hanei
