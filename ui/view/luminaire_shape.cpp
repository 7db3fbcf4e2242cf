#include "ui/view/luminaire_shape.h"

#include "engine/geometry/polygon.h"
#include "engine/scene/placement.h"

#include <array>
#include <cmath>
#include <numbers>

namespace hanei {
namespace {

constexpr int round_sides = 32;  // a 60 cm downlight drawn 100 pixels wide deviates by a quarter pixel

void outline_loop(LuminaireShape& shape, const Polygon& loop) {
    for (std::size_t k = 0; k < loop.size(); ++k) shape.outline.emplace_back(loop[k], loop[(k + 1) % loop.size()]);
}

/// A closed loop about the z axis at a height, counter-clockwise seen from above.
Polygon ellipse(double half_x, double half_y, double z) {
    Polygon loop;
    for (int k = 0; k < round_sides; ++k) {
        const double angle = 2.0 * std::numbers::pi * k / round_sides;
        loop.push_back({half_x * std::cos(angle), half_y * std::sin(angle), z});
    }
    return loop;
}

Polygon rectangle(double half_x, double half_y, double z) {
    return {{-half_x, -half_y, z}, {half_x, -half_y, z}, {half_x, half_y, z}, {-half_x, half_y, z}};
}

Polygon reversed(const Polygon& loop) { return {loop.rbegin(), loop.rend()}; }

/// Bottom, and with a height also top and sides, of a prism over `loop` centred on z = 0.
LuminaireShape prism(const Polygon& loop, double height) {
    LuminaireShape shape;
    Polygon bottom = loop, top = loop;
    for (Vec3& p : bottom) p.z -= 0.5 * height;
    for (Vec3& p : top) p.z += 0.5 * height;
    shape.shining.push_back(reversed(bottom));
    outline_loop(shape, bottom);
    if (height <= 0.0) return shape;
    shape.shining.push_back(top);
    outline_loop(shape, top);
    for (std::size_t k = 0; k < loop.size(); ++k) {
        const std::size_t next = (k + 1) % loop.size();
        shape.shining.push_back({bottom[k], bottom[next], top[next], top[k]});
        if (loop.size() == 4) shape.outline.emplace_back(bottom[k], top[k]);
    }
    return shape;
}

/// A box whose sides shine up to heights of their own: at planes 0, 90, 180 and 270, from its bottom.
LuminaireShape sided_box(double half_x, double half_y, double height, const std::array<double, 4>& sides) {
    LuminaireShape shape = prism(rectangle(half_x, half_y, -0.5 * height), 0.0);
    const Polygon bottom = rectangle(half_x, half_y, -0.5 * height);
    constexpr std::array<std::size_t, 4> plane_of_edge{3, 0, 1, 2};
    for (std::size_t k = 0; k < 4; ++k) {
        const Vec3 up{0.0, 0.0, sides[plane_of_edge[k]]};
        if (!(up.z > 0.0)) continue;
        const Vec3 from = bottom[k], to = bottom[(k + 1) % 4];
        const Polygon side{from, to, to + up, from + up};
        shape.shining.push_back(side);
        outline_loop(shape, side);
    }
    return shape;
}

LuminaireShape ellipsoid(const Vec3& half) {
    LuminaireShape shape;
    constexpr int belts = 8;
    for (int belt = 0; belt < belts; ++belt) {
        const double low = std::numbers::pi * (static_cast<double>(belt) / belts - 0.5);
        const double high = std::numbers::pi * (static_cast<double>(belt + 1) / belts - 0.5);
        const Polygon lower = ellipse(half.x * std::cos(low), half.y * std::cos(low), half.z * std::sin(low));
        const Polygon upper = ellipse(half.x * std::cos(high), half.y * std::cos(high), half.z * std::sin(high));
        for (std::size_t k = 0; k < lower.size(); ++k) {
            const std::size_t next = (k + 1) % lower.size();
            shape.shining.push_back({lower[k], lower[next], upper[next], upper[k]});
        }
    }
    outline_loop(shape, ellipse(half.x, half.y, 0.0));
    return shape;
}

/// Exchanges the axes so that what stood along z lies along x, x along y, y stands; twice: z along y.
LuminaireShape lying(LuminaireShape shape) {
    const auto turn = [](Vec3& p) { p = Vec3(p.z, p.x, p.y); };
    for (Polygon& polygon : shape.shining) {
        for (Vec3& p : polygon) turn(p);
    }
    for (auto& [from, to] : shape.outline) {
        turn(from);
        turn(to);
    }
    return shape;
}

LuminaireShape local_shape(const MeasuredOpeningSize& size) {
    const double x = 0.5 * size.extent_0, y = 0.5 * size.extent_90, z = size.height;
    switch (size.shape) {
        case OpeningShape::rectangle:
            return prism(rectangle(x, y, 0.0), 0.0);
        case OpeningShape::box:
            return size.side_heights ? sided_box(x, y, z, *size.side_heights) : prism(rectangle(x, y, 0.0), z);
        case OpeningShape::circle:
        case OpeningShape::ellipse:
            return prism(ellipse(x, y, 0.0), 0.0);
        case OpeningShape::vertical_cylinder:
            return prism(ellipse(x, y, 0.0), z);
        case OpeningShape::horizontal_cylinder:
            return lying(prism(ellipse(y, 0.5 * z, 0.0), size.extent_0));
        case OpeningShape::horizontal_cylinder_90:
            return lying(lying(prism(ellipse(0.5 * z, x, 0.0), size.extent_90)));
        case OpeningShape::sphere:
        case OpeningShape::ellipsoid:
            return ellipsoid({x, y, 0.5 * z});
        case OpeningShape::vertical_disc:
            return lying(prism(reversed(ellipse(y, 0.5 * z, 0.0)), 0.0));
        case OpeningShape::point:
            break;
    }
    LuminaireShape shape;
    shape.point = Vec3(0.0);
    return shape;
}

LuminaireShape local_shape(const Luminaire& luminaire, const Scene& scene) {
    LuminaireShape shape;
    if (const auto* line = std::get_if<LineOpening>(&luminaire.opening)) {
        shape.tube = {line->from, line->to};
    } else if (const auto* polygon = std::get_if<PolygonOpening>(&luminaire.opening)) {
        shape.shining = convex_pieces(polygon->region);
        outline_loop(shape, polygon->region.outline);
        for (const Polygon& hole : polygon->region.holes) outline_loop(shape, hole);
    } else if (const auto* solid = std::get_if<PolyhedronOpening>(&luminaire.opening)) {
        for (const std::vector<int>& face : solid->faces) {
            Polygon loop;
            for (const int vertex : face) loop.push_back(solid->vertices.at(static_cast<std::size_t>(vertex)));
            outline_loop(shape, loop);
            shape.shining.push_back(std::move(loop));
        }
    } else if (std::holds_alternative<MeasuredOpening>(luminaire.opening)) {
        const auto* measured = std::get_if<Measured>(&luminaire.distribution);
        for (const Photometry& photometry : scene.photometries) {
            if (measured != nullptr && photometry.id == measured->photometry) return local_shape(photometry.opening);
        }
        shape.point = Vec3(0.0);
    } else {
        shape.point = Vec3(0.0);
    }
    return shape;
}

}  // namespace

LuminaireShape shape_of(const Luminaire& luminaire, const Scene& scene) {
    LuminaireShape shape = local_shape(luminaire, scene);
    const Placement place = placement(luminaire);
    for (Polygon& polygon : shape.shining) {
        for (Vec3& p : polygon) p = place.point(p);
    }
    for (auto& [from, to] : shape.outline) {
        from = place.point(from);
        to = place.point(to);
    }
    if (shape.tube) shape.tube = {place.point(shape.tube->first), place.point(shape.tube->second)};
    if (shape.point) shape.point = place.point(*shape.point);
    return shape;
}

}  // namespace hanei
