#include "ui/view/sight.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace hanei {
namespace {

constexpr double nearest_depth = 1e-3;  // m: what is closer to the eye is not drawn

Ray difference(const Ray& a, const Ray& b) { return {a.origin - b.origin, a.direction - b.direction}; }

Box box_of(const DisplayMesh& display, const DisplayCell& cell) {
    const Vec3& first = display.vertices[cell.corner[0]].position;
    Box box{first, first};
    for (const std::uint32_t corner : cell.corner) box.include(display.vertices[corner].position);
    return box;
}

}  // namespace

Sight::Sight(const Solution& solution, const Camera& camera, double aspect)
    : planes_(camera.left_out, solution.scene.get()) {
    const CameraAxes axes = axes_of(camera);
    const auto scaled = [&](const Vec2& at) {
        Ray ray = ray_through(camera, at, aspect);
        ray.direction /= glm::dot(ray.direction, axes.forward);
        return ray;
    };
    corner_ = scaled({0.0, 0.0});
    right_ = difference(scaled({1.0, 0.0}), corner_);
    down_ = difference(scaled({0.0, 1.0}), corner_);

    const DisplayMesh& display = *solution.display;
    index_.assign(display.cells.size(), 0);
    std::vector<Box> boxes;
    for (std::uint32_t k = 0; k < display.cells.size(); ++k) {
        const DisplayCell& cell = display.cells[k];
        const Vec3& normal = solution.mesh->faces[cell.face].face.normal;
        const Vec3 to_eye =
            camera.orthographic ? -axes.forward : camera.eye - display.vertices[cell.corner[0]].position;
        if (!(glm::dot(normal, to_eye) > 0.0)) continue;
        index_[k] = static_cast<std::uint32_t>(frames_.size());
        cells_.push_back(k);
        frames_.push_back(frame_of(solution, cell));
        boxes.push_back(box_of(display, cell));
    }
    double extent = 0.0;
    for (const Box& box : boxes) {
        for (int axis = 0; axis < 3; ++axis)
            extent = std::max({extent, std::abs(box.low[axis]), std::abs(box.high[axis])});
    }
    // Cells are flat: their boxes need some thickness to be met.
    for (Box& box : boxes) {
        box.low -= Vec3(1e-9 * extent);
        box.high += Vec3(1e-9 * extent);
    }
    tree_ = RayTree(boxes);
}

Ray Sight::ray(const Vec2& at) const {
    return {corner_.origin + at.x * right_.origin + at.y * down_.origin,
            corner_.direction + at.x * right_.direction + at.y * down_.direction};
}

std::optional<Seen> Sight::through(const Vec2& at) const {
    const Ray ray = this->ray(at);
    Seen seen;
    seen.depth = std::numeric_limits<double>::infinity();
    std::uint32_t found = 0;
    Vec2 flat(0.0);
    tree_.visit(ray, nearest_depth, seen.depth, [&](std::uint32_t number) {
        const CellFrame& frame = frames_[number];
        const double against = glm::dot(ray.direction, frame.normal);
        const double depth = glm::dot(frame.origin - ray.origin, frame.normal) / against;
        const bool nearer = depth < seen.depth || (depth == seen.depth && number < found);
        if (!(against < 0.0) || !(depth > nearest_depth) || !nearer) return;
        const Vec3 place = ray.origin + depth * ray.direction;
        const Vec2 here = frame.flat(place);
        if (!contains(frame, here) || !planes_.keeps(place)) return;
        seen.depth = depth;
        found = number;
        flat = here;
    });
    if (!std::isfinite(seen.depth)) return std::nullopt;

    const CellFrame& frame = frames_[found];
    seen.cell = cells_[found];
    seen.at = glm::clamp(bilinear_coordinates(frame, flat), Vec2(0.0), Vec2(1.0));
    if (frame.triangle) seen.at.y = std::min(seen.at.y, seen.at.x);
    const Vec2 inside = seen.at.x * (1.0 - seen.at.y) * frame.corner[1] + seen.at.x * seen.at.y * frame.corner[2] +
                        (1.0 - seen.at.x) * seen.at.y * frame.corner[3];
    seen.place = frame.origin + inside.x * frame.along + inside.y * frame.across;
    return seen;
}

}  // namespace hanei
