#include "engine/direct/measured_source.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace hanei {

namespace {

/// Clockwise seen from +z, so that it faces down.
Polygon ellipse(double width, double depth) {
    constexpr int corners = 32;
    constexpr double step = 2.0 * std::numbers::pi / corners;
    const double same_area = std::sqrt(step / std::sin(step));
    Polygon outline;
    for (int k = 0; k < corners; ++k) {
        outline.emplace_back(0.5 * width * same_area * std::cos(-k * step),
                             0.5 * depth * same_area * std::sin(-k * step), 0.0);
    }
    return outline;
}

}  // namespace

Polygon measured_opening(const MeasuredOpeningSize& size) {
    if (size.shape == OpeningShape::point) return {};
    const bool upright = size.shape == OpeningShape::vertical_disc;
    double width = upright ? size.height : size.extent_0;
    double depth = size.extent_90;
    const double longest = std::max(width, depth);
    if (!(longest > 0.0)) return {};
    width = std::max(width, 0.01 * longest);
    depth = std::max(depth, 0.01 * longest);

    const bool angular = size.shape == OpeningShape::rectangle || size.shape == OpeningShape::box ||
                         size.shape == OpeningShape::horizontal_cylinder;
    const double x = 0.5 * width, y = 0.5 * depth;
    Polygon outline = angular ? Polygon{{-x, -y, 0.0}, {-x, y, 0.0}, {x, y, 0.0}, {x, -y, 0.0}} : ellipse(width, depth);
    if (upright) {
        for (Vec3& corner : outline) corner = {0.0, corner.y, corner.x};
    }
    return outline;
}

}  // namespace hanei
