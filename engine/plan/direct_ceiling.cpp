#include "engine/plan/direct_ceiling.h"

#include "engine/base/tolerance.h"
#include "engine/geometry/polygon.h"
#include "engine/scene/intensity.h"
#include "engine/scene/placement.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace hanei {
namespace {

constexpr double pi = std::numbers::pi;

double stated_flux(const Luminaire& luminaire) {
    const auto* flux = std::get_if<LuminousFlux>(&luminaire.output);
    return flux ? std::max(0.0, flux->value) : 0.0;
}

std::vector<Vec3> placed(const Placement& placement, std::span<const Vec3> places) {
    std::vector<Vec3> found;
    for (const Vec3& place : places) found.push_back(placement.point(place));
    return found;
}

/// Corners of a ball's box.
std::vector<Vec3> around(const Vec3& centre, double radius) { return {centre - Vec3{radius}, centre + Vec3{radius}}; }

const Photometry* photometry_of(const Scene& scene, const Luminaire& luminaire) {
    const auto* measured = std::get_if<Measured>(&luminaire.distribution);
    if (!measured) return nullptr;
    for (const Photometry& photometry : scene.photometries)
        if (photometry.id == measured->photometry && !photometry.candela.empty()) return &photometry;
    return nullptr;
}

/// cd in the direction of the most.
double greatest_intensity(const Luminaire& luminaire, const Photometry& photometry) {
    const double of_file = luminous_flux(photometry).value;
    const bool as_stated = std::holds_alternative<LuminousFlux>(luminaire.output);
    if (as_stated && !(of_file > 0.0)) return 0.0;
    return (as_stated ? stated_flux(luminaire) / of_file : 1.0) *
           lamp_tilt_factor(photometry, tilt_from_vertical(luminaire)) * peak_intensity(photometry).value;
}

/// The same of directions a right angle or more from the luminaire's nadir.
double greatest_upward(const Photometry& photometry) {
    if (photometry.type != PhotometricType::C) return peak_intensity(photometry).value;
    const std::vector<double>& gamma = photometry.vertical_deg;
    std::size_t first = 0;  // between two angles the intensity is between theirs
    while (first + 1 < gamma.size() && gamma[first + 1] <= 90.0) ++first;
    double greatest = 0.0;
    if (gamma.empty() || gamma.back() < 90.0) return greatest;  // nothing was found there
    for (std::size_t plane = 0; plane < photometry.horizontal_deg.size(); ++plane)
        for (std::size_t k = first; k < gamma.size(); ++k)
            greatest = std::max(greatest, photometry.candela[plane * gamma.size() + k]);
    return greatest;
}

/// A flat opening keeps its plane: behind it there is no light.
CeilingCell flat_cell(std::vector<Vec3> corners, const Vec3& normal, double area) {
    CeilingCell cell = cell_around(corners, area);
    cell.corners = std::move(corners);
    cell.normal = normal;
    cell.area = area;
    return cell;
}

}  // namespace

DirectCeiling::DirectCeiling(const Scene& scene, const Luminaire& luminaire) {
    const Placement placement = hanei::placement(luminaire);
    const Photometry* const photometry = photometry_of(scene, luminaire);
    if (photometry) {
        intensity_ = greatest_intensity(luminaire, *photometry);
        const double peak = peak_intensity(*photometry).value;
        upward_ = peak > 0.0 ? intensity_ / peak * greatest_upward(*photometry) : 0.0;
        axis_ = placement.direction({0.0, 0.0, -1.0});
        if (const auto* flat = std::get_if<PolygonOpening>(&luminaire.opening)) {
            shining_ = cell_around(hanei::placed(placement, flat->region.outline), 0.0);
        } else {
            // Half the diagonal of the opening, and a hundredth for the corners of a round one's polygon.
            const MeasuredOpeningSize& size = photometry->opening;
            const bool extended = std::holds_alternative<MeasuredOpening>(luminaire.opening);
            const double x = extended ? 0.505 * size.extent_0 : 0.0, y = extended ? 0.505 * size.extent_90 : 0.0;
            const double z = extended ? 1.01 * size.height : 0.0;
            std::vector<Vec3> corners;
            for (const double along : {-x, x})
                for (const double across : {-y, y})
                    for (const double up : {-z, z}) corners.emplace_back(along, across, up);
            corners = hanei::placed(placement, corners);
            shining_ = cell_around(corners, 0.0);
            shining_.corners = std::move(corners);
        }
        return;
    }
    const double flux = stated_flux(luminaire);
    const auto* luminance = std::get_if<Luminance>(&luminaire.output);
    shining_ = cell_around(around(placement.position, 0.0), 0.0);
    if (std::holds_alternative<PointOpening>(luminaire.opening)) {
        const auto* beam = std::get_if<CosinePower>(&luminaire.distribution);
        intensity_ = flux * (beam ? (beam->exponent + 1.0) / (2.0 * pi) : 0.25 / pi);
        upward_ = beam ? 0.0 : intensity_;
        axis_ = placement.direction({0.0, 0.0, -1.0});
    } else if (const auto* line = std::get_if<LineOpening>(&luminaire.opening)) {
        intensity_ = upward_ = flux / (pi * pi);
        shining_ = cell_around(std::vector{placement.point(line->from), placement.point(line->to)}, 0.0);
    } else if (const auto* flat = std::get_if<PolygonOpening>(&luminaire.opening)) {
        const double area = glm::length(vector_area(flat->region));
        if (!(area > 0.0)) return;
        exitance_ = luminance ? pi * std::max(0.0, luminance->value) : flux / area;
        const std::vector<Vec3> corners = hanei::placed(placement, flat->region.outline);
        shining_ = flat_cell(corners, unit_normal(corners), area);
    } else if (const auto* solid = std::get_if<PolyhedronOpening>(&luminaire.opening)) {
        double area = 0.0, weighted = 0.0, brightest = 0.0;
        for (std::size_t k = 0; k < solid->faces.size(); ++k) {
            Polygon face;
            for (const int v : solid->faces[k]) face.push_back(solid->vertices[static_cast<std::size_t>(v)]);
            const double weight = k < solid->relative_luminance.size() ? solid->relative_luminance[k] : 1.0;
            const double of_face = glm::length(vector_area(face));
            area += of_face;
            weighted += weight * of_face;
            brightest = std::max(brightest, weight);
        }
        if (!(weighted > 0.0)) return;
        exitance_ = brightest * (luminance ? pi * std::max(0.0, luminance->value) : flux / weighted);
        shining_ = cell_around(hanei::placed(placement, solid->vertices), area);
    }
}

/// A place on the opening, as near as rounding tells.
bool DirectCeiling::touches(const CeilingCell& cell) const {
    const double same_place = tolerance::same_place * (shining_.radius + glm::distance(cell.centre, shining_.centre));
    return cell.corners.size() == 1 && distance(cell, shining_) <= 2.0 * same_place;
}

/// Of the hemisphere, what a plane through the place can cover: the angle between both normals decides.
double DirectCeiling::half_turned(const CeilingCell& cell) const {
    return shining_.is_flat() ? std::min(1.0, 0.5 * (1.0 - glm::dot(cell.normal, shining_.normal)) + 1e-9) : 1.0;
}

double DirectCeiling::on(const CeilingCell& cell) const {
    if (exitance_ > 0.0) return exitance_ * (touches(cell) ? half_turned(cell) : most_seen(cell, shining_).factor);
    if (!(intensity_ > 0.0)) return 0.0;
    double intensity = intensity_;
    if (upward_ < intensity_) {
        double farthest = -std::numeric_limits<double>::infinity(), nearest = -farthest;
        for (const Vec3& corner : cell.corners) farthest = std::max(farthest, glm::dot(corner, axis_));
        for (const Vec3& corner : shining_.corners) nearest = std::min(nearest, glm::dot(corner, axis_));
        const double same_place = tolerance::same_place * (cell.radius + glm::distance(cell.centre, shining_.centre));
        if (farthest <= nearest + same_place) intensity = upward_;
        if (!(intensity > 0.0)) return 0.0;
    }
    const double apart = distance(cell, shining_);
    double cosine = 1.0;
    if (cell.is_flat()) {
        double height = -std::numeric_limits<double>::infinity();
        for (const Vec3& corner : shining_.corners)
            height = std::max(height, glm::dot(corner - cell.corners.front(), cell.normal));
        if (height <= tolerance::same_place * (cell.radius + glm::distance(cell.centre, shining_.centre))) return 0.0;
        if (apart > 0.0) cosine = std::min(1.0, height / apart);
    }
    return apart > 0.0 ? intensity * cosine / (apart * apart) : std::numeric_limits<double>::infinity();
}

}  // namespace hanei
