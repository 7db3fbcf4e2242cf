#include "engine/edit/intensity_of.h"

#include "engine/edit/luminaire_edits.h"
#include "engine/geometry/polygon.h"
#include "engine/scene/intensity.h"
#include "engine/scene/placement.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace hanei {
namespace {

constexpr double pi = std::numbers::pi;

/// lm, of openings that are not measured.
double own_flux(const Luminaire& luminaire) {
    if (const auto* flux = std::get_if<LuminousFlux>(&luminaire.output)) return std::max(0.0, flux->value);
    const auto* luminance = std::get_if<Luminance>(&luminaire.output);
    if (!luminance) return 0.0;
    double area = 0.0;
    if (const auto* flat = std::get_if<PolygonOpening>(&luminaire.opening))
        area = glm::length(vector_area(flat->region));
    if (const auto* solid = std::get_if<PolyhedronOpening>(&luminaire.opening)) {
        for (std::size_t k = 0; k < solid->faces.size(); ++k) {
            Polygon face;
            for (const int v : solid->faces[k]) face.push_back(solid->vertices[static_cast<std::size_t>(v)]);
            const double weight = k < solid->relative_luminance.size() ? solid->relative_luminance[k] : 1.0;
            area += weight * glm::length(vector_area(face));
        }
    }
    return pi * std::max(0.0, luminance->value) * area;
}

}  // namespace

IntensityOf::IntensityOf(const Scene& scene, const Luminaire& luminaire)
    : luminaire_(luminaire), photometry_(photometry_of(scene, luminaire)) {
    if (photometry_ && !photometry_->candela.empty()) {
        const double of_file = luminous_flux(*photometry_).value;
        const auto* stated = std::get_if<LuminousFlux>(&luminaire.output);
        if (stated) scale_ = of_file > 0.0 ? std::max(0.0, stated->value) / of_file : 0.0;
        scale_ *= lamp_tilt_factor(*photometry_, tilt_from_vertical(luminaire));
        flux_ = scale_ * of_file;
        return;
    }
    photometry_ = nullptr;
    flux_ = own_flux(luminaire);
    if (const auto* flat = std::get_if<PolygonOpening>(&luminaire.opening)) axis_ = unit_normal(flat->region.outline);
    if (const auto* line = std::get_if<LineOpening>(&luminaire.opening)) {
        const double length = glm::length(line->to - line->from);
        if (length > 0.0) axis_ = (line->to - line->from) / length;
    }
}

double IntensityOf::operator()(const Vec3& direction) const {
    if (photometry_) return scale_ * intensity(*photometry_, direction).value;
    const double cosine = glm::dot(direction, axis_);
    if (const auto* beam = std::get_if<CosinePower>(&luminaire_.distribution))
        return cosine > 0.0 ? flux_ * (beam->exponent + 1.0) / (2.0 * pi) * std::pow(cosine, beam->exponent) : 0.0;
    if (std::holds_alternative<PolygonOpening>(luminaire_.opening)) return flux_ / pi * std::max(0.0, cosine);
    if (std::holds_alternative<LineOpening>(luminaire_.opening))
        return flux_ / (pi * pi) * std::sqrt(std::max(0.0, 1.0 - cosine * cosine));
    return flux_ / (4.0 * pi);
}

}  // namespace hanei
