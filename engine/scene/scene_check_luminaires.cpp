#include "engine/scene/colour.h"
#include "engine/scene/scene_findings.h"

#include <algorithm>
#include <cmath>

namespace hanei {
namespace {

const char* kind_of(const Opening& opening) {
    constexpr const char* kinds[] = {"a point", "a line", "a polygon", "a polyhedron", "a measured opening"};
    return kinds[opening.index()];
}

struct OpeningCheck {
    ObjectFindings& object;

    void operator()(const PointOpening&) const {}
    void operator()(const MeasuredOpening&) const {}
    void operator()(const LineOpening& line) const {
        if (object.finite("opening.from", line.from) && object.finite("opening.to", line.to) && line.from == line.to)
            object.error("opening.to", "the line has no length; move one of its ends");
    }
    void operator()(const PolygonOpening& polygon) const { check_region(object, "opening", polygon.region); }
    void operator()(const PolyhedronOpening& solid) const {
        check_solid(object, "opening.faces", solid.vertices, solid.faces);
        const std::vector<double>& weights = solid.relative_luminance;
        if (!weights.empty() && weights.size() != solid.faces.size())
            object.error("opening.relative_luminance", "found " + std::to_string(weights.size()) + " weights for " +
                                                           std::to_string(solid.faces.size()) +
                                                           " faces; one a face is needed");
        const bool sound =
            std::all_of(weights.begin(), weights.end(), [](double w) { return std::isfinite(w) && w >= 0.0; });
        if (!sound) object.error("opening.relative_luminance", "every weight must be a finite number, 0 or more");
    }
};

/// Which distributions an opening can have.
void check_distribution(const Scene& scene, ObjectFindings& object, const Luminaire& luminaire) {
    const Opening& opening = luminaire.opening;
    const bool is_point = std::holds_alternative<PointOpening>(opening);
    const bool is_measured_opening = std::holds_alternative<MeasuredOpening>(opening);
    if (const auto* const power = std::get_if<CosinePower>(&luminaire.distribution)) {
        if (object.finite("distribution.exponent", {power->exponent}) && power->exponent < 0.0)
            object.error("distribution.exponent", "found " + figure(power->exponent) + ", it must be 0 or more");
        if (!is_point)
            object.error("distribution", std::string("a cosine power goes with a point, not with ") + kind_of(opening) +
                                             "; choose a diffuse distribution or a point");
    } else if (const auto* const measured = std::get_if<Measured>(&luminaire.distribution)) {
        const bool known = std::any_of(scene.photometries.begin(), scene.photometries.end(),
                                       [&](const Photometry& p) { return p.id == measured->photometry; });
        if (!known)
            object.error("distribution.photometry", "there is no such photometry; load its file or choose another");
        if (std::holds_alternative<LineOpening>(opening) || std::holds_alternative<PolyhedronOpening>(opening))
            object.error("distribution",
                         std::string("a measured distribution goes with a point, a polygon or a measured "
                                     "opening, not with ") +
                             kind_of(opening));
    } else if (is_measured_opening) {
        object.error("distribution", "a measured opening needs a measured distribution; choose a photometry");
    }
}

/// Which outputs an opening can have.
void check_output(ObjectFindings& object, const Luminaire& luminaire) {
    const bool measured = std::holds_alternative<Measured>(luminaire.distribution);
    const bool extended = std::holds_alternative<PolygonOpening>(luminaire.opening) ||
                          std::holds_alternative<PolyhedronOpening>(luminaire.opening);
    if (const auto* const flux = std::get_if<LuminousFlux>(&luminaire.output)) {
        if (object.finite("flux_lm", {flux->value}) && flux->value < 0.0)
            object.error("flux_lm", "found " + figure(flux->value) + " lm, a luminous flux cannot be negative");
    } else if (const auto* const luminance = std::get_if<Luminance>(&luminaire.output)) {
        if (object.finite("luminance_cd_m2", {luminance->value}) && luminance->value < 0.0)
            object.error("luminance_cd_m2",
                         "found " + figure(luminance->value) + " cd/m2, a luminance cannot be negative");
        if (!extended || measured)
            object.error("luminance_cd_m2",
                         std::string("a luminance goes with a diffuse polygon or polyhedron, not with ") +
                             (measured ? "a measured distribution" : kind_of(luminaire.opening)) +
                             "; give its luminous flux");
    } else if (!measured) {
        object.error("as_measured", "there is no photometry to take the output from; give a luminous flux");
    }
}

bool is_increasing(const std::vector<double>& angles) {
    for (std::size_t i = 0; i < angles.size(); ++i)
        if (!std::isfinite(angles[i]) || (i > 0 && !(angles[i] > angles[i - 1]))) return false;
    return !angles.empty();
}

void check_photometry(SceneChecks& checks, const Photometry& photometry, std::size_t index) {
    ObjectFindings object = checks.about("photometries", index, "photometry", photometry.name, photometry.id);
    checks.check_id(object, photometry.id);
    for (const auto& [field, angles] :
         {std::pair{"horizontal_deg", &photometry.horizontal_deg}, std::pair{"vertical_deg", &photometry.vertical_deg}})
        if (!is_increasing(*angles))
            object.error(field, "the angles must be finite and increase; there must be at least one");
    const std::size_t expected = photometry.horizontal_deg.size() * photometry.vertical_deg.size();
    if (photometry.candela.size() != expected)
        object.error("candela", "found " + std::to_string(photometry.candela.size()) + " intensities, " +
                                    std::to_string(expected) + " belong to its angles");
    const bool sound = std::all_of(photometry.candela.begin(), photometry.candela.end(),
                                   [](double value) { return std::isfinite(value) && value >= 0.0; });
    if (!sound) object.error("candela", "every intensity must be a finite number, 0 or more");
    const MeasuredOpeningSize& size = photometry.opening;
    if (object.finite("opening", {size.extent_0, size.extent_90, size.height}) &&
        (size.extent_0 < 0.0 || size.extent_90 < 0.0 || size.height < 0.0))
        object.error("opening", "the extents of the luminous opening cannot be negative");
}

}  // namespace

void check_colour_temperature(ObjectFindings& object, double kelvin) {
    if (!object.finite("colour_temperature_k", {kelvin}) || kelvin == 0.0) return;
    if (kelvin < lowest_colour_temperature || kelvin > highest_colour_temperature)
        object.error("colour_temperature_k", "found " + figure(kelvin) + " K, allowed are 0 (neutral) and " +
                                                 figure(lowest_colour_temperature) + " to " +
                                                 figure(highest_colour_temperature) + " K");
}

void check_photometries(SceneChecks& checks) {
    for (std::size_t i = 0; i < checks.scene.photometries.size(); ++i)
        check_photometry(checks, checks.scene.photometries[i], i);
}

void check_luminaires(SceneChecks& checks) {
    for (std::size_t i = 0; i < checks.scene.luminaires.size(); ++i) {
        const Luminaire& luminaire = checks.scene.luminaires[i];
        ObjectFindings object = checks.about("luminaires", i, "luminaire", luminaire.name, luminaire.id);
        checks.check_id(object, luminaire.id);
        object.finite("position", luminaire.position);
        object.finite("yaw_deg", {luminaire.yaw});
        object.finite("tilt_deg", {luminaire.tilt});
        object.finite("roll_deg", {luminaire.roll});
        object.within("dimming", luminaire.dimming, 0.0, 1.0);
        check_colour_temperature(object, luminaire.colour_temperature);
        std::visit(OpeningCheck{object}, luminaire.opening);
        check_distribution(checks.scene, object, luminaire);
        check_output(object, luminaire);
    }
}

}  // namespace hanei
