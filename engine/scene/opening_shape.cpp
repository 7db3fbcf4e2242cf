#include "engine/scene/opening_shape.h"

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

OpeningSolid::Kind kind_of(OpeningShape shape) {
    switch (shape) {
        case OpeningShape::vertical_cylinder:
        case OpeningShape::horizontal_cylinder:
        case OpeningShape::horizontal_cylinder_90:
            return OpeningSolid::Kind::cylinder;
        case OpeningShape::sphere:
        case OpeningShape::ellipsoid:
            return OpeningSolid::Kind::ellipsoid;
        default:
            return OpeningSolid::Kind::box;
    }
}

int axis_of(OpeningShape shape) {
    if (shape == OpeningShape::horizontal_cylinder) return 0;
    return shape == OpeningShape::horizontal_cylinder_90 ? 1 : 2;
}

}  // namespace

double OpeningSolid::projected_area(const Vec3& e) const {
    switch (kind) {
        case Kind::box: {
            const double towards_0 = e.x >= 0.0 ? sides[0] : sides[2];
            const double towards_90 = e.y >= 0.0 ? sides[1] : sides[3];
            return 4.0 * half.x * half.y * std::abs(e.z) + 2.0 * half.y * towards_0 * std::abs(e.x) +
                   2.0 * half.x * towards_90 * std::abs(e.y);
        }
        case Kind::cylinder: {
            const int a = (axis + 1) % 3, b = (axis + 2) % 3;
            const double across = half[a] * half[a] * e[b] * e[b] + half[b] * half[b] * e[a] * e[a];
            return std::numbers::pi * half[a] * half[b] * std::abs(e[axis]) + 4.0 * half[axis] * std::sqrt(across);
        }
        case Kind::ellipsoid:
            break;
    }
    const Vec3 faces = Vec3{half.y * half.z, half.x * half.z, half.x * half.y} * e;
    return std::numbers::pi * std::sqrt(glm::dot(faces, faces));
}

Vec3 OpeningSolid::areas_along_axes() const {
    const auto greater = [this](const Vec3& e) { return std::max(projected_area(e), projected_area(-e)); };
    return {greater({1.0, 0.0, 0.0}), greater({0.0, 1.0, 0.0}), greater({0.0, 0.0, 1.0})};
}

bool is_solid(const MeasuredOpeningSize& size) {
    switch (size.shape) {
        case OpeningShape::point:
        case OpeningShape::rectangle:
        case OpeningShape::circle:
        case OpeningShape::ellipse:
        case OpeningShape::vertical_disc:
            return false;
        default:
            return size.height > 0.0;
    }
}

OpeningSolid solid_opening(const MeasuredOpeningSize& size) {
    const double least = 0.01 * std::max({size.extent_0, size.extent_90, size.height});
    const Vec3 extent = glm::max(Vec3(size.extent_0, size.extent_90, size.height), Vec3(least));
    OpeningSolid solid{kind_of(size.shape), 0.5 * extent, axis_of(size.shape), {}};
    solid.sides.fill(extent.z);
    if (size.side_heights) {
        for (std::size_t k = 0; k < 4; ++k) solid.sides[k] = std::clamp((*size.side_heights)[k], 0.0, extent.z);
    }
    return solid;
}

Polygon flat_opening(const MeasuredOpeningSize& size) {
    if (size.shape == OpeningShape::point) return {};
    const bool upright = size.shape == OpeningShape::vertical_disc;
    double width = upright ? size.height : size.extent_0;
    double depth = size.extent_90;
    const double longest = std::max(width, depth);
    if (!(longest > 0.0)) return {};
    width = std::max(width, 0.01 * longest);
    depth = std::max(depth, 0.01 * longest);

    const bool angular = size.shape == OpeningShape::rectangle || size.shape == OpeningShape::box ||
                         size.shape == OpeningShape::horizontal_cylinder ||
                         size.shape == OpeningShape::horizontal_cylinder_90;
    const double x = 0.5 * width, y = 0.5 * depth;
    Polygon outline = angular ? Polygon{{-x, -y, 0.0}, {-x, y, 0.0}, {x, y, 0.0}, {x, -y, 0.0}} : ellipse(width, depth);
    if (upright) {
        for (Vec3& corner : outline) corner = {0.0, corner.y, corner.x};
    }
    return outline;
}

}  // namespace hanei
