#include "engine/report/photometry_figures.h"
#include "engine/report/photometry_report.h"
#include "engine/scene/colour.h"
#include "engine/scene/point_certificate.h"

#include <cmath>
#include <nlohmann/json.hpp>

namespace hanei {
namespace {

using Json = nlohmann::ordered_json;

template <class Value>
Json or_null(const std::optional<Value>& value) {
    return value ? Json(*value) : Json(nullptr);
}

Json span_json(const std::optional<AngleSpan>& span) {
    if (!span) return nullptr;
    return {
        {"width_deg", span->width_deg()}, {"from_deg", span->from_deg}, {"to_deg", span->to_deg}, {"cut", span->cut}};
}

Json plane_json(const PlaneFigures& plane) {
    return {{"plane_deg", plane.plane_deg},
            {"peak_cd", plane.peak.value},
            {"upward", plane.upward},
            {"beam_50_percent", span_json(plane.beam)},
            {"field_10_percent", span_json(plane.field)}};
}

Json lamp_sets_json(const Photometry& photometry) {
    Json sets = Json::array();
    for (const LampSet& set : photometry.lamp_sets) {
        sets.push_back({{"count", set.count},
                        {"type", set.type},
                        {"lumens", set.lumens},
                        {"colour", set.colour},
                        {"rendering", set.rendering},
                        {"watts", set.watts}});
    }
    return sets;
}

Json tilt_json(const Photometry& photometry) {
    if (!photometry.tilt) return nullptr;
    return {{"file", photometry.tilt->file},
            {"geometry", photometry.tilt->geometry},
            {"angle_deg", photometry.tilt->angle_deg},
            {"factor", photometry.tilt->factor},
            {"applied", photometry.tilt->geometry != 2 && !photometry.tilt->factor.empty()}};
}

Json declared_json(const Photometry& photometry, const PhotometryFigures& figures) {
    return {{"lamps", photometry.lamps},
            {"absolute", photometry.absolute},
            {"lamp_lumens", photometry.lamp_lumens},
            {"lamp_sets", lamp_sets_json(photometry)},
            {"colour_temperature_k", or_null(stated_colour_temperature(photometry))},
            {"lamp_set", photometry.lamp_set + 1},
            {"input_watts", photometry.input_watts},
            {"candela_per_figure", photometry.candela_per_figure},
            {"flux_lm", figures.declared_flux ? Json(figures.declared_flux->value) : Json(nullptr)},
            {"output_ratio", or_null(photometry.declared_output_ratio)},
            {"downward_share", or_null(photometry.declared_downward_share)},
            {"tilt", tilt_json(photometry)}};
}

Json computed_json(const PhotometryFigures& figures) {
    return {{"flux_lm", figures.flux.value},
            {"flux_zone_average_lm", figures.zone_average_flux.value},
            {"flux_difference", or_null(figures.flux_difference)},
            {"output_ratio", or_null(figures.output_ratio)},
            {"downward_share", or_null(figures.downward_share)},
            {"efficacy_lm_per_w", or_null(figures.efficacy)},
            {"peak_cd", figures.peak.value},
            {"peak_horizontal_deg", figures.peak_at.horizontal_deg},
            {"peak_vertical_deg", figures.peak_at.vertical_deg},
            {"symmetry", name_of(figures.symmetry_found)},
            {"seam_difference", or_null(figures.seam_difference)},
            {"planes", {plane_json(figures.plane_0), plane_json(figures.plane_90)}},
            {"point_distance_m", or_null(figures.point_distance)},
            {"differences", figures.differences}};
}

Json opening_json(const MeasuredOpeningSize& opening) {
    return {{"shape", name_of(opening.shape)},
            {"extent_c0_c180_m", opening.extent_0},
            {"extent_c90_c270_m", opening.extent_90},
            {"height_m", opening.height},
            {"side_heights_m", or_null(opening.side_heights)}};
}

/// From where on the luminaire is a point, by what that leaves out at most.
Json point_json(const Photometry& photometry) {
    const PointCertificate certificate(photometry);
    Json rows = Json::array();
    for (const double percent : {10.0, 1.0, 0.1, 0.01}) {
        const double distance = certificate.distance_for(0.01 * percent);
        rows.push_back({{"error_percent_of_peak", percent},
                        {"beyond_m", std::isfinite(distance) ? Json(distance) : Json(nullptr)}});
    }
    return rows;
}

Json keywords_json(const Photometry& photometry) {
    Json keywords = Json::array();
    for (const auto& [key, text] : photometry.keywords) keywords.push_back({key, text});
    return keywords;
}

Json json_of(const Photometry& photometry, std::string_view file) {
    const PhotometryFigures figures = photometry_figures(photometry);
    return {{"file", file},
            {"name", photometry.name},
            {"format", photometry.format},
            {"photometric_type", name_of(photometry.type)},
            {"symmetry", name_of(photometry.symmetry)},
            {"horizontal_deg", photometry.horizontal_deg},
            {"vertical_deg", photometry.vertical_deg},
            {"declared", declared_json(photometry, figures)},
            {"computed", computed_json(figures)},
            {"opening", opening_json(photometry.opening)},
            {"quarter_turns", photometry.quarter_turns},
            {"point_model", point_json(photometry)},
            {"keywords", keywords_json(photometry)},
            {"warnings", photometry.warnings}};
}

std::string text_of(const Json& json) { return json.dump(2, ' ', false, Json::error_handler_t::replace) + '\n'; }

}  // namespace

std::string photometry_json(const Photometry& photometry, std::string_view file) {
    return text_of(json_of(photometry, file));
}

std::string photometries_json(const std::vector<Photometry>& photometries, std::string_view file) {
    if (photometries.size() == 1) return photometry_json(photometries.front(), file);
    Json luminaires = Json::array();
    for (const Photometry& photometry : photometries) luminaires.push_back(json_of(photometry, file));
    return text_of({{"file", file}, {"luminaires", std::move(luminaires)}});
}

}  // namespace hanei
