#include "engine/direct/flat_cell.h"

#include "engine/geometry/polygon.h"

#include <algorithm>
#include <cmath>

namespace hanei {

namespace {

/// Sums over the triangles of a fan, seen from its first corner.
struct Moments {
    double area = 0.0;
    double x = 0.0, y = 0.0, xx = 0.0, xy = 0.0, yy = 0.0;

    void add(const Vec2& b, const Vec2& c) {
        const double part = 0.5 * (b.x * c.y - b.y * c.x);
        const Vec2 sum = b + c;
        area += part;
        x += part / 3.0 * sum.x;
        y += part / 3.0 * sum.y;
        xx += part / 12.0 * (b.x * b.x + c.x * c.x + sum.x * sum.x);
        xy += part / 12.0 * (b.x * b.y + c.x * c.y + sum.x * sum.y);
        yy += part / 12.0 * (b.y * b.y + c.y * c.y + sum.y * sum.y);
    }
};

}  // namespace

FlatCell::FlatCell(Polygon outline) : corners(std::move(outline)) {
    if (corners.empty()) return;
    centre = corners[0];
    if (corners.size() == 1) {
        size = 1.0;
        places[0] = centre;
        count = 1;
        return;
    }
    if (corners.size() == 2) {
        constexpr double of_length = 0.28867513459481287;  // 1 / sqrt 12
        size = glm::distance(corners[0], corners[1]);
        centre = 0.5 * (corners[0] + corners[1]);
        along = of_length * (corners[1] - corners[0]);
        places = {centre - along, centre + along};
        count = 2;
        return;
    }
    const Vec3 normal = vector_area(corners);
    const double normal_length = glm::length(normal);
    if (!(normal_length > 0.0)) return;
    Vec3 longest = corners[1] - corners[0];
    for (std::size_t k = 2; k < corners.size(); ++k) {
        const Vec3 side = corners[k] - corners[0];
        if (glm::dot(side, side) > glm::dot(longest, longest)) longest = side;
    }
    const Vec3 u = longest / glm::length(longest);
    const Vec3 v = glm::cross(normal, u) / normal_length;
    const auto flat = [&](const Vec3& corner) {
        const Vec3 away = corner - corners[0];
        return Vec2{glm::dot(away, u), glm::dot(away, v)};
    };
    Moments sums;
    Vec2 before = flat(corners[1]);
    for (std::size_t k = 2; k < corners.size(); ++k) {
        const Vec2 here = flat(corners[k]);
        sums.add(before, here);
        before = here;
    }
    if (!(sums.area > 0.0)) return;
    size = sums.area;
    const double x = sums.x / size, y = sums.y / size;
    const double xx = std::max(0.0, sums.xx / size - x * x), yy = std::max(0.0, sums.yy / size - y * y);
    const double xy = sums.xy / size - x * y;
    // The greater variance and its direction; alike in all directions, any will do.
    const double half = 0.5 * (xx - yy), root = std::sqrt(half * half + xy * xy), middle = 0.5 * (xx + yy);
    Vec2 axis = half >= 0.0 ? Vec2{half + root, xy} : Vec2{xy, root - half};
    const double axis_length = glm::length(axis);
    axis = axis_length > 1e-12 * middle ? axis / axis_length : Vec2{1.0, 0.0};
    centre = corners[0] + x * u + y * v;
    along = std::sqrt(middle + root) * (axis.x * u + axis.y * v);
    across = std::sqrt(std::max(0.0, middle - root)) * (axis.x * v - axis.y * u);
    places = {centre - along - across, centre + along - across, centre - along + across, centre + along + across};
    count = 4;
}

FlatCell FlatCell::without_nodes(Polygon outline) {
    FlatCell cell;
    cell.size = glm::length(vector_area(outline));
    cell.corners = std::move(outline);
    return cell;
}

std::vector<FlatCell> FlatCell::halves() const {
    std::vector<FlatCell> parts;
    if (corners.size() < 2 || count == 0) return parts;
    if (corners.size() == 2) {
        parts.emplace_back(Polygon{corners[0], centre});
        parts.emplace_back(Polygon{centre, corners[1]});
        return parts;
    }
    const Vec3 way = glm::normalize(along);
    for (const double side : {-1.0, 1.0}) {
        FlatCell half(clipped(corners, {centre, side * way}, 0.0));
        if (half.count > 0) parts.push_back(std::move(half));
    }
    return parts;
}

}  // namespace hanei
