#include "ui/view/cell_field.h"

#include <algorithm>
#include <cmath>

namespace hanei {
namespace {

constexpr double border = 1e-9;  // of the cell's size squared: neighbours share their border without a gap

double cross(const Vec2& a, const Vec2& b) { return a.x * b.y - a.y * b.x; }

}  // namespace

CellFrame frame_of(const Solution& solution, const DisplayCell& cell) {
    const DisplayMesh& display = *solution.display;
    CellFrame frame;
    frame.normal = solution.mesh->faces[cell.face].face.normal;
    frame.origin = display.vertices[cell.corner[0]].position;
    frame.triangle = cell.corner[3] == cell.corner[2];
    const Vec3 diagonal = display.vertices[cell.corner[2]].position - frame.origin;
    const Vec3 side = display.vertices[cell.corner[1]].position - frame.origin;
    const Vec3 longer = glm::dot(side, side) > 1e-12 * glm::dot(diagonal, diagonal) ? side : diagonal;
    const double length = glm::length(longer);
    if (length > 0.0) frame.along = longer / length;
    frame.across = glm::cross(frame.normal, frame.along);
    for (std::size_t k = 0; k < 4; ++k) frame.corner[k] = frame.flat(display.vertices[cell.corner[k]].position);
    if (frame.triangle) frame.corner[3] = frame.corner[2] - frame.corner[1];
    return frame;
}

std::array<double, 4> corner_values(const DisplayMesh& display, const DisplayCell& cell, LightPart part) {
    std::array<double, 4> values{};
    for (std::size_t k = 0; k < 4; ++k) {
        values[k] = static_cast<double>(value_of(display.vertices[cell.corner[k]], part));
    }
    if (cell.corner[3] == cell.corner[2]) values[3] = values[0] + values[2] - values[1];
    return values;
}

Vec2 bilinear_coordinates(const CellFrame& frame, const Vec2& flat) {
    // place = u e + v f + u v g; eliminating u leaves a v^2 + b v + c = 0 with the positive root the
    // one inside a counter-clockwise convex cell. Written so that it holds for parallelograms (a = 0).
    const Vec2& e = frame.corner[1];
    const Vec2& f = frame.corner[3];
    const Vec2 g = frame.corner[2] - e - f;
    const double a = cross(g, f);
    const double b = cross(e, f) + cross(flat, g);
    const double c = cross(flat, e);
    const double root = std::sqrt(std::max(0.0, b * b - 4.0 * a * c));
    const double divisor = b >= 0.0 ? b + root : 2.0 * a;
    if (divisor == 0.0) return Vec2(0.0);
    const double v = b >= 0.0 ? -2.0 * c / divisor : (root - b) / divisor;
    const Vec2 row = e + v * g;
    const double length = glm::dot(row, row);
    return {length > 0.0 ? glm::dot(flat - v * f, row) / length : 0.0, v};
}

double bilinear(const std::array<double, 4>& values, const Vec2& at) {
    const double lower = values[0] + at.x * (values[1] - values[0]);
    const double upper = values[3] + at.x * (values[2] - values[3]);
    return lower + at.y * (upper - lower);
}

bool contains(const CellFrame& frame, const Vec2& flat) {
    const std::size_t corners = frame.triangle ? 3 : 4;
    const double slack = -border * glm::dot(frame.corner[2], frame.corner[2]);
    for (std::size_t k = 0; k < corners; ++k) {
        const Vec2& from = frame.corner[k];
        const Vec2& to = frame.corner[(k + 1) % corners];
        if (cross(to - from, flat - from) < slack) return false;
    }
    return true;
}

}  // namespace hanei
