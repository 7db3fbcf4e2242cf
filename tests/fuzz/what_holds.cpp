#include "tests/fuzz/what_holds.h"

#include "engine/base/check.h"
#include "engine/project/luminaire_text.h"
#include "engine/scene/intensity.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <iostream>
#include <utility>
#include <vector>

namespace hanei {
namespace {

/// Finite, and not below 0.
bool is_amount(double value) { return std::isfinite(value) && value >= 0.0; }

bool all_finite(const std::vector<double>& values) {
    return std::all_of(values.begin(), values.end(), [](double value) { return std::isfinite(value); });
}

void check_angles(const std::vector<double>& angles) {
    HANEI_CHECK(all_finite(angles));
    HANEI_CHECK(std::is_sorted(angles.begin(), angles.end(), std::less_equal<>{}));
}

void check_lamps(const Photometry& photometry) {
    HANEI_CHECK(photometry.lamps >= 0 && is_amount(photometry.lamp_lumens));
    HANEI_CHECK(std::isfinite(photometry.input_watts) && std::isfinite(photometry.candela_per_figure));
    HANEI_CHECK(photometry.lamp_sets.empty() || photometry.lamp_set < photometry.lamp_sets.size());
    for (const LampSet& lamps : photometry.lamp_sets)
        HANEI_CHECK(std::isfinite(lamps.count) && std::isfinite(lamps.lumens) && std::isfinite(lamps.watts));
    for (const auto& share : {photometry.declared_output_ratio, photometry.declared_downward_share})
        HANEI_CHECK(std::isfinite(share.value_or(0.0)));
    if (!photometry.tilt) return;
    HANEI_CHECK(photometry.tilt->angle_deg.size() == photometry.tilt->factor.size());
    HANEI_CHECK(all_finite(photometry.tilt->factor));
    check_angles(photometry.tilt->angle_deg);
}

/// Directions all around, on and between the planes and circles that files use.
void check_intensities(const Photometry& photometry) {
    const double peak = peak_intensity(photometry).value;
    for (double plane = -180.0; plane <= 180.0; plane += 37.5) {
        for (double vertical = -180.0; vertical <= 180.0; vertical += 22.5) {
            const Vec3 direction = photometric_direction(photometry.type, {plane, vertical});
            const double towards = intensity(photometry, direction).value;
            HANEI_CHECK(is_amount(towards));
            HANEI_CHECK(towards <= peak * (1.0 + 1e-9));  // an interpolant is never above its table
        }
    }
}

void check_fluxes(const Photometry& photometry) {
    const double total = luminous_flux(photometry).value;
    const double downward = downward_flux(photometry).value;
    HANEI_CHECK(is_amount(total) && is_amount(downward) && is_amount(zone_average_flux(photometry).value));
    HANEI_CHECK(downward <= total * (1.0 + 1e-9));
}

/// The least project that can be read: a photometry needs one to be kept in.
const Project& empty_room() {
    static const ProjectRead read = read_project_text(R"({
        "format": "hanei-project", "version": 1, "materials": [{"name": "grey", "reflectance": 0.5}],
        "room": {"plan": [[0, 0], [5, 0], [5, 4], [0, 4]], "height": 3,
                 "floor": "grey", "ceiling": "grey", "walls": "grey"}})",
                                                      "/nowhere/room.hanei");
    HANEI_CHECK(read.project.has_value());
    return *read.project;
}

}  // namespace

std::string_view text_of(const std::uint8_t* bytes, std::size_t count) {
    return {reinterpret_cast<const char*>(bytes), count};
}

void check_findings(const Diagnostics& findings, bool accepted) {
    HANEI_CHECK(has_errors(findings) != accepted);
    for (const Diagnostic& finding : findings) {
        HANEI_CHECK(!finding.message.empty());
        HANEI_CHECK(finding.place.line >= 0);
        HANEI_CHECK(to_text(finding).find(finding.message) != std::string::npos);
    }
}

void check_photometry(const Photometry& photometry) {
    HANEI_CHECK(!photometry.horizontal_deg.empty() && photometry.vertical_deg.size() >= 2);
    HANEI_CHECK(photometry.candela.size() == photometry.horizontal_deg.size() * photometry.vertical_deg.size());
    check_angles(photometry.horizontal_deg);
    check_angles(photometry.vertical_deg);
    HANEI_CHECK(std::all_of(photometry.candela.begin(), photometry.candela.end(), is_amount));
    const MeasuredOpeningSize& opening = photometry.opening;
    HANEI_CHECK(is_amount(opening.extent_0) && is_amount(opening.extent_90) && is_amount(opening.height));
    check_lamps(photometry);
    check_intensities(photometry);
    check_fluxes(photometry);
    Project project = empty_room();
    project.scene.photometries.push_back(photometry);
    project.scene.photometries.back().id = project.scene.new_id();
    check_project(project);
}

void check_project(const Project& project) {
    const std::string text = project_text(project);
    const ProjectRead again = read_project_text(text, "/nowhere/again.hanei");
    if (!again.project)
        for (const Diagnostic& finding : again.findings) std::cerr << to_text(finding) << '\n';
    HANEI_CHECK(again.project.has_value());
    HANEI_CHECK(*again.project == project);
    HANEI_CHECK(project_text(*again.project) == text);
}

void check_reader(LuminaireReader reader, const std::uint8_t* bytes, std::size_t count) {
    LuminaireFindings findings{"file"};
    const std::vector<Photometry> photometries = reader(decoded_text(text_of(bytes, count)), findings);
    check_findings(findings.diagnostics(), !findings.failed());
    if (findings.failed()) return;
    HANEI_CHECK(!photometries.empty());
    for (const Photometry& photometry : photometries) check_photometry(photometry);
}

}  // namespace hanei
