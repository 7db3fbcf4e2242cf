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

/// The outline of a measured flat opening in the luminaire's frame, seen from below
/// counter-clockwise; empty for openings that are not flat.
Polygon measured_outline(const MeasuredOpeningSize& size) {
    const double x = 0.5 * size.extent_0;
    const double y = 0.5 * size.extent_90;
    if (!(x > 0.0 && y > 0.0)) return {};
    if (size.shape == OpeningShape::rectangle) return {{-x, -y, 0.0}, {-x, y, 0.0}, {x, y, 0.0}, {x, -y, 0.0}};
    if (size.shape != OpeningShape::circle && size.shape != OpeningShape::ellipse) return {};
    constexpr int corners = 32;  // inscribed: its area is 0.6 % under the circle's
    Polygon outline;
    for (int k = 0; k < corners; ++k) {
        const double angle = -2.0 * std::numbers::pi * k / corners;
        outline.emplace_back(x * std::cos(angle), y * std::sin(angle), 0.0);
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
        found.push_back(std::move(body));
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
