#include "engine/report/photometry_report.h"

#include "engine/report/photometry_figures.h"
#include "engine/scene/colour.h"
#include "engine/scene/point_certificate.h"

#include <cmath>
#include <fmt/format.h>
#include <optional>

namespace hanei {
namespace {

/// Lines "  label   value", labels in a column.
class Lines {
public:
    explicit Lines(std::string title) : text_(std::move(title) + '\n') {}
    template <class... Values>
    void add(std::string_view label, fmt::format_string<Values...> format, Values&&... values) {
        text_ += fmt::format("  {:<20}{}\n", label, fmt::format(format, std::forward<Values>(values)...));
    }
    const std::string& text() const { return text_; }

private:
    std::string text_;
};

std::string angles_text(const std::vector<double>& angles) {
    if (angles.size() == 1) return fmt::format("{:g}", angles.front());
    return fmt::format("{:g} to {:g} ({})", angles.front(), angles.back(), angles.size());
}

std::string share_text(const std::optional<double>& share) {
    return share ? fmt::format("{:.1f} %", 100.0 * *share) : "not stated";
}

void add_tilt(Lines& lines, const LampTilt& tilt) {
    const std::string where = tilt.file.empty() ? "the file" : tilt.file;
    if (tilt.factor.empty()) {
        lines.add("lamp tilt", "in the file {}, not read", where);
    } else {
        lines.add(
            "lamp tilt", "{} factors in {}, {}", tilt.factor.size(), where,
            tilt.geometry == 2 ? "none applied: the lamp stays horizontal" : "applied where the luminaire is tilted");
    }
}

void add_lamps(Lines& lines, const Photometry& photometry) {
    for (std::size_t k = 0; k < photometry.lamp_sets.size(); ++k) {
        const LampSet& set = photometry.lamp_sets[k];
        const std::string label = fmt::format("lamp set {}{}", k + 1, k == photometry.lamp_set ? ", used" : "");
        lines.add(label, "{:g} x {}, {:g} lm together, {:g} W, colour {}, rendering {}", set.count,
                  set.type.empty() ? "lamp" : set.type, set.lumens, set.watts, set.colour, set.rendering);
    }
    const std::optional<double> kelvin = stated_colour_temperature(photometry);
    lines.add("colour temperature", "{}",
              kelvin ? fmt::format("{:g} K: a luminaire hung from this file shines so", *kelvin)
                     : "none in plain kelvin: a luminaire hung from this file is neutral");
    if (photometry.absolute) {
        lines.add("lamps", "absolute photometry");
    } else {
        lines.add("lamps", "{}, {:g} lm together", photometry.lamps, photometry.lamp_lumens);
    }
    lines.add("input", "{:g} W", photometry.input_watts);
    if (photometry.tilt) add_tilt(lines, *photometry.tilt);
}

void add_flux(Lines& lines, const Photometry& photometry, const PhotometryFigures& figures) {
    lines.add("flux declared", "{}",
              figures.declared_flux ? fmt::format("{:.1f} lm", figures.declared_flux->value) : "not stated");
    lines.add("flux computed", "{:.1f} lm by the exact integral, {:.1f} lm by zone averages", figures.flux.value,
              figures.zone_average_flux.value);
    if (figures.flux_difference)
        lines.add("flux difference", "{:+.2f} % of the declared flux", 100.0 * *figures.flux_difference);
    lines.add("output ratio", "declared {}, computed {}", share_text(photometry.declared_output_ratio),
              figures.output_ratio ? share_text(figures.output_ratio) : "not available");
    lines.add("downward share", "declared {}, computed {}", share_text(photometry.declared_downward_share),
              figures.downward_share ? share_text(figures.downward_share) : "not available");
    lines.add("efficacy", "{}", figures.efficacy ? fmt::format("{:.1f} lm/W", *figures.efficacy) : "not available");
}

std::string span_text(const std::optional<AngleSpan>& span) {
    if (!span) return "none";
    return fmt::format("{:.1f} deg ({:.1f} to {:.1f}{})", span->width_deg(), span->from_deg, span->to_deg,
                       span->cut ? ", cut at the horizontal" : "");
}

void add_plane(Lines& lines, const PlaneFigures& plane) {
    lines.add(fmt::format("plane {:g}-{:g}", plane.plane_deg, plane.plane_deg + 180.0),
              "peak {:.1f} cd{}, beam {}, field {}", plane.peak.value, plane.upward ? " upward" : "",
              span_text(plane.beam), span_text(plane.field));
}

void add_opening(Lines& lines, const MeasuredOpeningSize& opening) {
    lines.add("luminous opening", "{}, {:g} m along plane 0, {:g} m along plane 90, {:g} m high",
              name_of(opening.shape), opening.extent_0, opening.extent_90, opening.height);
    if (!opening.side_heights) return;
    const auto& sides = *opening.side_heights;
    lines.add("heights of sides", "{:g} m at C0, {:g} m at C90, {:g} m at C180, {:g} m at C270", sides[0], sides[1],
              sides[2], sides[3]);
}

std::string point_text(const Photometry& photometry) {
    const PointCertificate certificate(photometry);
    if (certificate.opening().radius == 0.0) return "always: the file states no opening";
    std::string text;
    for (const double share : {1e-1, 1e-2, 1e-3}) {
        const double distance = certificate.distance_for(share);
        text +=
            fmt::format("{}{} for {:g} %", text.empty() ? "" : ", ",
                        std::isfinite(distance) ? fmt::format("beyond {:.3g} m", distance) : "nowhere", 100.0 * share);
    }
    return text + " of the peak";
}

}  // namespace

std::string_view name_of(PhotometricType type) {
    switch (type) {
        case PhotometricType::A:
            return "A";
        case PhotometricType::B:
            return "B";
        case PhotometricType::C:
            break;
    }
    return "C";
}

std::string_view name_of(PhotometricSymmetry symmetry) {
    switch (symmetry) {
        case PhotometricSymmetry::none:
            return "none";
        case PhotometricSymmetry::rotational:
            return "rotational";
        case PhotometricSymmetry::quadrant:
            return "about the planes 0-180 and 90-270";
        case PhotometricSymmetry::plane_0:
            return "about the plane 0-180";
        case PhotometricSymmetry::plane_90:
            break;
    }
    return "about the plane 90-270";
}

std::string_view name_of(OpeningShape shape) {
    switch (shape) {
        case OpeningShape::point:
            return "point";
        case OpeningShape::rectangle:
            return "rectangle";
        case OpeningShape::circle:
            return "circle";
        case OpeningShape::ellipse:
            return "ellipse";
        case OpeningShape::box:
            return "box";
        case OpeningShape::vertical_cylinder:
            return "vertical cylinder";
        case OpeningShape::horizontal_cylinder:
            return "horizontal cylinder along plane 0";
        case OpeningShape::horizontal_cylinder_90:
            return "horizontal cylinder along plane 90";
        case OpeningShape::sphere:
            return "sphere";
        case OpeningShape::ellipsoid:
            return "ellipsoid";
        case OpeningShape::vertical_disc:
            break;
    }
    return "vertical disc facing plane 0";
}

std::string photometry_text(const Photometry& photometry) {
    const PhotometryFigures figures = photometry_figures(photometry);
    Lines lines{photometry.name.empty() ? photometry.source_file : photometry.name};
    lines.add("format", "{}, type {}", photometry.format, name_of(photometry.type));
    lines.add("symmetry", "declared {}; found {}", name_of(photometry.symmetry), name_of(figures.symmetry_found));
    lines.add("horizontal angles", "{}", angles_text(photometry.horizontal_deg));
    lines.add("vertical angles", "{}", angles_text(photometry.vertical_deg));
    add_lamps(lines, photometry);
    add_flux(lines, photometry, figures);
    lines.add("peak", "{:.1f} cd at horizontal {:g}, vertical {:g}", figures.peak.value, figures.peak_at.horizontal_deg,
              figures.peak_at.vertical_deg);
    add_plane(lines, figures.plane_0);
    add_plane(lines, figures.plane_90);
    add_opening(lines, photometry.opening);
    lines.add("as a point", "{}", point_text(photometry));
    if (figures.seam_difference)
        lines.add("planes 0 and 360", "differ by {:.2g} % of the peak", 100.0 * *figures.seam_difference);
    if (photometry.quarter_turns != 0) lines.add("turned", "by {} degrees", 90 * photometry.quarter_turns);
    for (const std::string& difference : figures.differences) lines.add("note", "{}", difference);
    for (const std::string& warning : photometry.warnings) lines.add("warning", "{}", warning);
    return lines.text();
}

}  // namespace hanei
