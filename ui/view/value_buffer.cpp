#include "ui/view/value_buffer.h"

#include "engine/geometry/polygon.h"
#include "ui/view/cell_field.h"
#include "ui/view/left_out.h"
#include "ui/view/luminaire_shape.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace hanei {
namespace {

/// Visits the pixels whose centres may lie in a convex polygon, with the place on its plane.
class Raster {
public:
    Raster(const Camera& camera, PixelSize size)
        : camera_(camera), axes_(axes_of(camera)), size_(size), low_corner_(ray(Vec2(0.0))) {
        right_ = difference(ray(Vec2(1.0, 0.0)), low_corner_);
        down_ = difference(ray(Vec2(0.0, 1.0)), low_corner_);
    }

    bool faces_eye(const Vec3& place, const Vec3& normal) const {
        return glm::dot(normal, camera_.orthographic ? -axes_.forward : camera_.eye - place) > 0.0;
    }

    template <class Visit>
    void cover(const Polygon& polygon, const Vec3& normal, const Visit& visit) const {
        const Box box = box_of(polygon);
        for (int y = box.low_y; y <= box.high_y; ++y) {
            for (int x = box.low_x; x <= box.high_x; ++x) {
                const Ray through = ray_of_pixel(x, y);
                const double against = glm::dot(through.direction, normal);
                const double depth = glm::dot(polygon.front() - through.origin, normal) / against;
                if (std::isfinite(depth) && depth > 0.0) visit(x, y, depth, through.origin + depth * through.direction);
            }
        }
    }

private:
    struct Box {
        int low_x = 0, low_y = 0, high_x = -1, high_y = -1;
    };

    /// Directions have length 1 along the line of sight, so that they add up across the picture.
    Ray ray(Vec2 at) const {
        Ray through = ray_through(camera_, at, size_.aspect());
        through.direction /= glm::dot(through.direction, axes_.forward);
        return through;
    }
    static Ray difference(const Ray& a, const Ray& b) { return {a.origin - b.origin, a.direction - b.direction}; }

    Ray ray_of_pixel(int x, int y) const {
        const double u = (x + 0.5) / size_.width, v = (y + 0.5) / size_.height;
        return {low_corner_.origin + u * right_.origin + v * down_.origin,
                low_corner_.direction + u * right_.direction + v * down_.direction};
    }

    Box box_of(const Polygon& polygon) const {
        const double nearest = 1e-3;  // m: what is closer to the eye than a millimetre is not drawn
        const Plane before_eye{camera_.eye + nearest * axes_.forward, axes_.forward};
        const Polygon shown = camera_.orthographic ? polygon : clipped(polygon, before_eye, 0.0);
        Vec2 low(1e300), high(-1e300);
        for (const Vec3& corner : shown) {
            const auto at = projected(camera_, corner, size_.aspect());
            if (!at) continue;
            low = glm::min(low, *at);
            high = glm::max(high, *at);
        }
        const auto pixel = [](double share, int count) {
            return static_cast<int>(std::floor(std::clamp(share, -1.0, 2.0) * count));
        };
        if (low.x > high.x) return {};
        return {std::max(0, pixel(low.x, size_.width)), std::max(0, pixel(low.y, size_.height)),
                std::min(size_.width - 1, pixel(high.x, size_.width)),
                std::min(size_.height - 1, pixel(high.y, size_.height))};
    }

    const Camera& camera_;
    CameraAxes axes_;
    PixelSize size_;
    Ray low_corner_, right_, down_;
};

void draw_cells(ValueBuffer& buffer, const Raster& raster, const Solution& solution, LightPart part,
                const CutPlanes& planes) {
    const DisplayMesh& display = *solution.display;
    for (const DisplayCell& cell : display.cells) {
        const Vec3& normal = solution.mesh->faces[cell.face].face.normal;
        if (!raster.faces_eye(display.vertices[cell.corner[0]].position, normal)) continue;
        const CellFrame frame = frame_of(solution, cell);
        const std::array<double, 4> values = corner_values(display, cell, part);
        Polygon outline;
        for (const std::uint32_t corner : cell.corner) outline.push_back(display.vertices[corner].position);
        raster.cover(outline, normal, [&](int x, int y, double depth, const Vec3& place) {
            const std::size_t pixel = buffer.at(x, y);
            const Vec2 flat = frame.flat(place);
            if (static_cast<float>(depth) >= buffer.depth[pixel] || !contains(frame, flat) || !planes.keeps(place))
                return;
            const Vec2 uv = glm::clamp(bilinear_coordinates(frame, flat), Vec2(0.0), Vec2(1.0));
            buffer.depth[pixel] = static_cast<float>(depth);
            buffer.face[pixel] = static_cast<int>(cell.face);
            buffer.lux[pixel] = static_cast<float>(bilinear(values, uv));
        });
    }
}

void cover(ValueBuffer& buffer, const Raster& raster, const Polygon& convex, const Vec3& normal, double slack) {
    raster.cover(convex, normal, [&](int x, int y, double depth, const Vec3& place) {
        const std::size_t pixel = buffer.at(x, y);
        if (depth - slack > static_cast<double>(buffer.depth[pixel])) return;
        for (std::size_t k = 0; k < convex.size(); ++k) {
            const Vec3 side = convex[(k + 1) % convex.size()] - convex[k];
            if (glm::dot(glm::cross(side, place - convex[k]), normal) < 0.0) return;
        }
        buffer.face[pixel] = ValueBuffer::luminaire;
    });
}

void draw_sections(ValueBuffer& buffer, const Raster& raster, const Scene& scene, const CutPlanes& planes) {
    for (const std::optional<Cut>& plane : {planes.cut, planes.ceiling}) {
        if (!plane) continue;
        for (const Polygon& section : sections_of(scene, *plane)) cover(buffer, raster, section, plane->normal, 0.0);
    }
}

void draw_luminaires(ValueBuffer& buffer, const Raster& raster, const Scene& scene, const CutPlanes& planes) {
    for (const Luminaire& luminaire : scene.luminaires) {
        if (!CutPlanes::is_kept(planes.cut, luminaire.position)) continue;
        for (const Polygon& opening : shape_of(luminaire, scene).shining) {
            const Vec3 normal = unit_normal(opening);
            if (normal == Vec3(0.0)) continue;
            const double slack = 1e-3 * diameter(opening);  // set flush into a ceiling it still covers it
            cover(buffer, raster, opening, normal, slack);
        }
    }
}

}  // namespace

ValueBuffer value_buffer(const Solution& solution, const Camera& camera, const ViewOptions& look, PixelSize size) {
    ValueBuffer buffer;
    buffer.size = size;
    const std::size_t pixels = static_cast<std::size_t>(size.width) * static_cast<std::size_t>(size.height);
    buffer.lux.assign(pixels, 0.0F);
    buffer.depth.assign(pixels, std::numeric_limits<float>::infinity());
    buffer.face.assign(pixels, ValueBuffer::nothing);
    const Raster raster(camera, size);
    const CutPlanes planes(camera.left_out, solution.scene.get());
    draw_cells(buffer, raster, solution, look.part, planes);
    if (solution.scene == nullptr) return buffer;
    draw_sections(buffer, raster, *solution.scene, planes);
    if (look.luminaires) draw_luminaires(buffer, raster, *solution.scene, planes);
    return buffer;
}

}  // namespace hanei
