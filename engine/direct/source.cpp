#include "engine/direct/source.h"

#include "engine/geometry/polygon.h"
#include "engine/scene/intensity.h"
#include "engine/scene/opening_shape.h"

#include <algorithm>
#include <numbers>

namespace hanei {

using std::numbers::pi;

namespace {

const Photometry* find_photometry(const Scene& scene, ObjectId id) {
    const auto found = std::ranges::find(scene.photometries, id, &Photometry::id);
    return found == scene.photometries.end() ? nullptr : &*found;
}

/// A source that gives no light, for a luminaire without a usable opening.
MadeSource dark(const Placement& placed) { return {LuminousFlux{0.0}, PointSource{placed, 0.0}}; }

double flux_of(const Luminaire& luminaire) {
    const auto* flux = std::get_if<LuminousFlux>(&luminaire.output);
    return flux ? flux->value : 0.0;
}

/// The exitance of faces of weight 1, from their flux or their luminance.
double exitance_of(const Luminaire& luminaire, double weighted_area) {
    if (const auto* luminance = std::get_if<Luminance>(&luminaire.output)) return pi * luminance->value;
    return weighted_area > 0.0 ? flux_of(luminaire) / weighted_area : 0.0;
}

MadeSource point(const Luminaire& luminaire) {
    const Placement placed = placement(luminaire);
    const double flux = flux_of(luminaire);
    if (const auto* beam = std::get_if<CosinePower>(&luminaire.distribution)) {
        return {{flux}, PointSource{placed, beam->exponent, flux * (beam->exponent + 1.0) / (2.0 * pi)}};
    }
    return {{flux}, PointSource{placed, flux / (4.0 * pi)}};
}

MadeSource line(const Luminaire& luminaire, const LineOpening& opening) {
    const Placement placed = placement(luminaire);
    const double length = glm::distance(opening.from, opening.to);
    if (!(length > 0.0)) return dark(placed);
    const double flux = flux_of(luminaire);
    return {{flux}, LineSource{placed.point(opening.from), placed.point(opening.to), flux / (pi * pi * length)}};
}

MadeSource panel(const Luminaire& luminaire, const PolygonOpening& opening) {
    const Placement placed = placement(luminaire);
    const double area = glm::length(vector_area(opening.region));
    const double exitance = exitance_of(luminaire, area);
    return {{exitance * area}, DiffuseSource{{{placed.region(opening.region), exitance}}, false}};
}

bool is_convex_solid(const std::vector<LuminousFace>& faces) {
    for (const LuminousFace& face : faces) {
        const Plane plane{face.region.outline[0], unit_normal(face.region.outline)};
        for (const LuminousFace& other : faces) {
            const double farthest = 1e-9 * (diameter(other.region.outline) + diameter(face.region.outline));
            for (const Vec3& corner : other.region.outline) {
                if (plane.height(corner) > farthest) return false;
            }
        }
    }
    return true;
}

MadeSource solid(const Luminaire& luminaire, const PolyhedronOpening& opening) {
    const Placement placed = placement(luminaire);
    std::vector<LuminousFace> faces;
    double weighted_area = 0.0;
    for (std::size_t k = 0; k < opening.faces.size(); ++k) {
        const double weight = k < opening.relative_luminance.size() ? opening.relative_luminance[k] : 1.0;
        Region region;
        for (const int vertex : opening.faces[k]) {
            region.outline.push_back(placed.point(opening.vertices[static_cast<std::size_t>(vertex)]));
        }
        if (region.outline.size() < 3) continue;
        weighted_area += weight * glm::length(vector_area(region));
        faces.push_back({std::move(region), weight});
    }
    const double exitance = exitance_of(luminaire, weighted_area);
    for (LuminousFace& face : faces) face.exitance *= exitance;
    const bool convex = is_convex_solid(faces);
    return {{exitance * weighted_area}, DiffuseSource{std::move(faces), !convex}};
}

MadeSource measured(const Scene& scene, const Luminaire& luminaire, const Measured& distribution) {
    const Placement placed = placement(luminaire);
    const Photometry* photometry = find_photometry(scene, distribution.photometry);
    if (!photometry || photometry->candela.empty()) return dark(placed);
    const double file_flux = luminous_flux(*photometry).value;
    const auto* wanted = std::get_if<LuminousFlux>(&luminaire.output);
    const double of_file = wanted ? (file_flux > 0.0 ? wanted->value / file_flux : 0.0) : 1.0;
    const double scale = of_file * lamp_tilt_factor(*photometry, tilt_from_vertical(luminaire));
    const LuminousFlux flux{scale * file_flux};

    const bool as_filed = std::holds_alternative<MeasuredOpening>(luminaire.opening);
    if (as_filed && is_solid(photometry->opening))
        return {flux, MeasuredSource{placed, solid_opening(photometry->opening), *photometry, scale}};
    Region opening;
    if (const auto* polygon = std::get_if<PolygonOpening>(&luminaire.opening)) opening = polygon->region;
    if (as_filed) opening.outline = flat_opening(photometry->opening);
    if (convex_pieces(opening).empty()) return {flux, PointSource{placed, *photometry, scale}};
    return {flux, MeasuredSource{placed, opening, *photometry, scale}};
}

}  // namespace

MadeSource make_source(const Scene& scene, const Luminaire& luminaire) {
    if (const auto* table = std::get_if<Measured>(&luminaire.distribution)) return measured(scene, luminaire, *table);
    if (const auto* tube = std::get_if<LineOpening>(&luminaire.opening)) return line(luminaire, *tube);
    if (const auto* flat = std::get_if<PolygonOpening>(&luminaire.opening)) return panel(luminaire, *flat);
    if (const auto* body = std::get_if<PolyhedronOpening>(&luminaire.opening)) return solid(luminaire, *body);
    return point(luminaire);
}

}  // namespace hanei
