#include "engine/base/tolerance.h"
#include "engine/geometry/polygon.h"
#include "engine/mesh/contact.h"
#include "engine/mesh/pieces.h"
#include "engine/scene/placement.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

namespace hanei {

namespace {

ConvexBody flat_body(Polygon polygon, std::uint32_t owner) {
    std::vector<int> face(polygon.size());
    std::iota(face.begin(), face.end(), 0);
    return {std::move(polygon), {std::move(face)}, owner};
}

Polygon corners_of(const ConvexBody& body, std::size_t face) {
    Polygon corners;
    for (const int vertex : body.faces[face]) corners.push_back(body.vertices[static_cast<std::size_t>(vertex)]);
    return corners;
}

/// No vertex stands out over the plane of a face.
bool is_convex_solid(const ConvexBody& body) {
    const double thickness = tolerance::planar * diameter(body.vertices);
    for (std::size_t face = 0; face < body.faces.size(); ++face) {
        const Polygon corners = corners_of(body, face);
        const Plane plane{corners.front(), unit_normal(corners)};
        for (const Vec3& vertex : body.vertices) {
            if (plane.height(vertex) > thickness) return false;
        }
    }
    return true;
}

/// The outline of a measured opening in the luminaire's frame, facing down; empty for points and
/// upright discs. Round ones are polygons of the same area.
Polygon measured_outline(const MeasuredOpeningSize& size) {
    const double x = 0.5 * size.extent_0;
    const double y = 0.5 * size.extent_90;
    if (!(x > 0.0 && y > 0.0)) return {};
    if (size.shape == OpeningShape::point || size.shape == OpeningShape::vertical_disc) return {};
    const bool angular = size.shape == OpeningShape::rectangle || size.shape == OpeningShape::box ||
                         size.shape == OpeningShape::horizontal_cylinder;
    if (angular) return {{-x, -y, 0.0}, {-x, y, 0.0}, {x, y, 0.0}, {x, -y, 0.0}};
    constexpr int corners = 32;
    constexpr double step = 2.0 * std::numbers::pi / corners;
    const double same_area = std::sqrt(step / std::sin(step));
    Polygon outline;
    for (int k = 0; k < corners; ++k) {
        outline.emplace_back(same_area * x * std::cos(-k * step), same_area * y * std::sin(-k * step), 0.0);
    }
    return outline;
}

struct BodiesOf {
    const Scene& scene;
    const Luminaire& luminaire;
    std::vector<ConvexBody>& found;

    void operator()(const PointOpening&) const {}
    void operator()(const LineOpening&) const {}
    void operator()(const PolygonOpening& flat) const {
        const Region region = placement(luminaire).region(flat.region);
        for (Polygon& piece : pieces_of(region, unit_normal(region.outline))) {
            found.push_back(flat_body(std::move(piece), luminaire.id.value));
        }
    }
    void operator()(const PolyhedronOpening& solid) const {
        ConvexBody body{{}, solid.faces, luminaire.id.value};
        for (const Vec3& vertex : solid.vertices) body.vertices.push_back(placement(luminaire).point(vertex));
        if (is_convex_solid(body)) {
            found.push_back(std::move(body));
            return;
        }
        for (std::size_t face = 0; face < body.faces.size(); ++face) {
            const Region region{corners_of(body, face), {}};
            for (Polygon& piece : pieces_of(region, unit_normal(region.outline)))
                found.push_back(flat_body(std::move(piece), luminaire.id.value));
        }
    }
    void operator()(const MeasuredOpening&) const {
        const auto* measured = std::get_if<Measured>(&luminaire.distribution);
        if (!measured) return;
        for (const Photometry& photometry : scene.photometries) {
            if (photometry.id != measured->photometry) continue;
            Polygon outline = measured_outline(photometry.opening);
            for (Vec3& corner : outline) corner = placement(luminaire).point(corner);
            if (!outline.empty()) found.push_back(flat_body(std::move(outline), luminaire.id.value));
        }
    }
};

}  // namespace

std::vector<ConvexBody> opaque_openings(const Scene& scene) {
    std::vector<ConvexBody> found;
    for (const Luminaire& luminaire : scene.luminaires) {
        if (luminaire.opaque) std::visit(BodiesOf{scene, luminaire, found}, luminaire.opening);
    }
    return found;
}

}  // namespace hanei
