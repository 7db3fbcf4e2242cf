#include "ui/view/drawn_about.h"

#include <cmath>

namespace hanei {
namespace {

constexpr double step = 64.0;  // of the scene's size: places stay exact to a millionth of it

thread_local Vec3 counted_from{0.0};

}  // namespace

DrawnAbout::DrawnAbout(const Vec3& origin) { counted_from = origin; }
DrawnAbout::~DrawnAbout() { counted_from = Vec3{0.0}; }

glm::vec3 drawn(const Vec3& place) { return glm::vec3(place - counted_from); }

Vec3 drawing_origin(const Bounds& bounds) {
    const double size = bounds.diameter();
    if (!(size > 0.0) || !std::isfinite(size)) return Vec3{0.0};
    const double grid = step * std::exp2(std::ceil(std::log2(size)));
    return grid * glm::round(0.5 * (bounds.low + bounds.high) / grid);
}

}  // namespace hanei
