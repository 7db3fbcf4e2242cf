#include "engine/plan/light_bounds.h"

#include "engine/geometry/polygon.h"
#include "engine/scene/colour.h"
#include "engine/scene/dimmers.h"
#include "engine/scene/intensity.h"
#include "engine/scene/placement.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace hanei {

namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();
constexpr double pi = std::numbers::pi;

double distance_to_segment(const Vec3& place, const Vec3& a, const Vec3& b) {
    const Vec3 edge = b - a;
    const double square = glm::dot(edge, edge);
    const double t = square > 0.0 ? std::clamp(glm::dot(place - a, edge) / square, 0.0, 1.0) : 0.0;
    return glm::length(place - a - t * edge);
}

/// From a place to a face; a hole is taken as part of the face, which can only make it nearer.
double distance_to_face(const Vec3& place, const Face& face) {
    const double height = glm::dot(place - face.region.outline.front(), face.normal);
    double nearest = infinite;
    double turns = 0.0;  // how often the outline runs around the place's foot
    const Vec3 foot = place - height * face.normal;
    for (std::size_t k = 0; k < face.region.outline.size(); ++k) {
        const Vec3& a = face.region.outline[k];
        const Vec3& b = face.region.outline[(k + 1) % face.region.outline.size()];
        nearest = std::min(nearest, distance_to_segment(place, a, b));
        turns += std::atan2(glm::dot(glm::cross(a - foot, b - foot), face.normal), glm::dot(a - foot, b - foot));
    }
    return std::abs(turns) > pi ? std::min(nearest, std::abs(height)) : nearest;
}

/// Least distance from any place within `radius` of `centre` to a face whose front it may shine on.
double distance_to_fronts(const Vec3& centre, double radius, std::span<const Face> faces) {
    double nearest = infinite;
    for (const Face& face : faces) {
        if (glm::dot(centre - face.region.outline.front(), face.normal) < -radius) continue;
        nearest = std::min(nearest, distance_to_face(centre, face) - radius);
    }
    return std::max(0.0, nearest);
}

struct Emitted {
    double flux = 0.0;    ///< lm at full output
    double direct = 0.0;  ///< lx on any surface at full output, at most
    bool extent = true;
};

/// What one luminaire gives, by its opening and distribution.
class EmittedBy {
public:
    EmittedBy(const Scene& scene, const Luminaire& luminaire, std::span<const Face> faces)
        : scene_(scene), luminaire_(luminaire), faces_(faces), placed_(placement(luminaire)) {}

    Emitted operator()() const {
        if (const auto* measured = std::get_if<Measured>(&luminaire_.distribution)) return from_table(*measured);
        return std::visit([this](const auto& opening) { return from(opening); }, luminaire_.opening);
    }

private:
    double stated_flux() const {
        const auto* flux = std::get_if<LuminousFlux>(&luminaire_.output);
        return flux ? std::max(0.0, flux->value) : 0.0;
    }
    double at_distance(double intensity, double distance) const {
        if (intensity <= 0.0) return 0.0;
        return distance > 0.0 ? intensity / (distance * distance) : infinite;
    }

    Emitted from(const PointOpening&) const {
        const auto* beam = std::get_if<CosinePower>(&luminaire_.distribution);
        const double peak = stated_flux() * (beam ? (beam->exponent + 1.0) / (2.0 * pi) : 0.25 / pi);
        return {stated_flux(), at_distance(peak, distance_to_fronts(placed_.position, 0.0, faces_)), false};
    }
    Emitted from(const MeasuredOpening&) const { return {stated_flux(), stated_flux() > 0.0 ? infinite : 0.0, true}; }

    /// Nearer than d the line gives less than I1 x integral d / r^3 ds < 2 I1 / d (no cosine at the
    /// receiver). Its distance is bounded from pieces, each less than its half length.
    Emitted from(const LineOpening& line) const {
        const double length = glm::length(line.to - line.from);
        if (!(length > 0.0)) return {};
        constexpr int pieces = 64;
        double distance = infinite;
        for (int k = 0; k < pieces; ++k) {
            const Vec3 middle = line.from + (k + 0.5) / pieces * (line.to - line.from);
            distance = std::min(distance, distance_to_fronts(placed_.point(middle), 0.5 * length / pieces, faces_));
        }
        const double normal_intensity = stated_flux() / (pi * pi * length);
        if (normal_intensity <= 0.0) return {};
        return {stated_flux(), distance > 0.0 ? 2.0 * normal_intensity / distance : infinite, true};
    }

    /// A diffuse opening cannot light a surface above its own exitance.
    Emitted from(const PolygonOpening& flat) const {
        const double area = glm::length(vector_area(flat.region));
        if (!(area > 0.0)) return {};
        if (const auto* luminance = std::get_if<Luminance>(&luminaire_.output)) {
            return {pi * luminance->value * area, pi * luminance->value, true};
        }
        return {stated_flux(), stated_flux() / area, true};
    }
    Emitted from(const PolyhedronOpening& solid) const {
        double weighted_area = 0.0;
        double greatest = 0.0;
        for (std::size_t k = 0; k < solid.faces.size(); ++k) {
            const double weight = k < solid.relative_luminance.size() ? solid.relative_luminance[k] : 1.0;
            Polygon face;
            for (const int v : solid.faces[k]) face.push_back(solid.vertices[static_cast<std::size_t>(v)]);
            weighted_area += weight * glm::length(vector_area(face));
            greatest = std::max(greatest, weight);
        }
        if (!(weighted_area > 0.0)) return {};
        const auto* luminance = std::get_if<Luminance>(&luminaire_.output);
        const double exitance = luminance ? pi * luminance->value : stated_flux() / weighted_area;
        return {exitance * weighted_area, exitance * greatest, true};
    }

    Emitted from_table(const Measured& measured) const {
        for (const Photometry& photometry : scene_.photometries) {
            if (photometry.id != measured.photometry || photometry.candela.empty()) continue;
            const double of_file = luminous_flux(photometry).value;
            const bool as_stated = std::holds_alternative<LuminousFlux>(luminaire_.output);
            if (as_stated && !(of_file > 0.0)) return {};
            const double scale = (as_stated ? stated_flux() / of_file : 1.0) *
                                 lamp_tilt_factor(photometry, tilt_from_vertical(luminaire_));
            const double radius = radius_of(photometry);
            const double distance = distance_to_fronts(placed_.position, radius, faces_);
            return {scale * of_file, at_distance(scale * peak_intensity(photometry).value, distance), radius > 0.0};
        }
        return {};
    }
    /// The opening lies within this of the luminaire's place.
    double radius_of(const Photometry& photometry) const {
        double radius = 0.0;
        if (const auto* flat = std::get_if<PolygonOpening>(&luminaire_.opening)) {
            for (const Vec3& corner : flat->region.outline) radius = std::max(radius, glm::length(corner));
        } else if (std::holds_alternative<MeasuredOpening>(luminaire_.opening)) {
            const MeasuredOpeningSize& size = photometry.opening;
            if (size.shape != OpeningShape::point) {
                constexpr double of_polygon = 1.01;  // corners of a round opening's polygon of equal area
                radius = 0.5 * of_polygon * glm::length(Vec3(size.extent_0, size.extent_90, size.height));
            }
        }
        return radius;
    }

    const Scene& scene_;
    const Luminaire& luminaire_;
    std::span<const Face> faces_;
    Placement placed_;
};

}  // namespace

double LightBounds::first_exitance() const { return own_exitance + (reflectance > 0.0 ? reflectance * direct : 0.0); }

double LightBounds::interreflected_after(int bounces) const {
    const double first = first_exitance();
    if (first <= 0.0) return 0.0;
    if (reflectance <= 0.0) return bounces == 0 ? first : 0.0;
    if (reflectance >= 1.0) return infinite;
    return first * std::pow(reflectance, bounces) / (1.0 - reflectance);
}

LightBounds light_bounds(const Scene& scene, std::span<const Face> faces) {
    LightBounds bounds;
    for (const Luminaire& luminaire : scene.luminaires) {
        const Emitted full = EmittedBy(scene, luminaire, faces)();
        const double output = dimming_of(scene, luminaire) * scene.maintenance_factor;
        if (!(full.flux > 0.0) || !(output > 0.0)) continue;
        bounds.flux += output * full.flux;
        bounds.direct += output * full.direct;
        ++bounds.luminaires;
        if (full.extent) ++bounds.luminaires_with_extent;
    }
    const auto include = [&](ObjectId id) {
        if (const Material* material = find_material(scene, id)) {
            for (const double band : band_reflectances(*material))
                bounds.reflectance = std::max(bounds.reflectance, band);
        }
    };
    for (const Face& face : faces) {
        include(face.material);
        for (const FaceArea& area : face.areas) include(area.material);
        bounds.own_exitance = std::max(bounds.own_exitance, face.own_exitance.value);
    }
    return bounds;
}

}  // namespace hanei
