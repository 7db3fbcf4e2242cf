#include "engine/report/photometry_figures.h"

#include "engine/scene/point_certificate.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <fmt/format.h>
#include <iterator>
#include <string_view>

namespace hanei {
namespace {

/// Directions of a plane in steps of a tenth of a degree: finer than any table of a file.
constexpr int steps_a_degree = 10;
constexpr int half = 90 * steps_a_degree;

double degrees(int step) { return static_cast<double>(step) / steps_a_degree; }

/// Intensities of half a plane, -90 to 90 degrees about the nadir or the zenith.
std::vector<double> profile(const Photometry& photometry, double plane_deg, bool upward) {
    std::vector<double> values;
    values.reserve(2 * half + 1);
    for (int step = -half; step <= half; ++step) {
        const double from_pole = degrees(std::abs(step));
        const PhotometricAngles angles{step < 0 ? plane_deg + 180.0 : plane_deg,
                                       upward ? 180.0 - from_pole : from_pole};
        values.push_back(intensity(photometry, photometric_direction(PhotometricType::C, angles)).value);
    }
    return values;
}

/// Where the line between two neighbouring values crosses the level, as steps after the first.
double crossing(double before, double after, double level) { return (level - before) / (after - before); }

std::optional<AngleSpan> span_above(const std::vector<double>& values, double level) {
    if (!(level > 0.0)) return std::nullopt;
    int first = 0;
    int last = 2 * half;
    const auto value = [&values](int k) { return values[static_cast<std::size_t>(k)]; };
    while (first < last && value(first) < level) ++first;
    while (last > first && value(last) < level) --last;
    AngleSpan span{degrees(first - half), degrees(last - half), first == 0 || last == 2 * half};
    if (first > 0)
        span.from_deg = degrees(first - 1 - half) + crossing(value(first - 1), value(first), level) / steps_a_degree;
    if (last < 2 * half)
        span.to_deg = degrees(last - half) + crossing(value(last), value(last + 1), level) / steps_a_degree;
    return span;
}

PlaneFigures plane_figures(const Photometry& photometry, double plane_deg) {
    const std::vector<double> down = profile(photometry, plane_deg, false);
    const std::vector<double> up = profile(photometry, plane_deg, true);
    const double down_peak = *std::max_element(down.begin(), down.end());
    const double up_peak = *std::max_element(up.begin(), up.end());
    PlaneFigures figures;
    figures.plane_deg = plane_deg;
    figures.upward = up_peak > down_peak;
    figures.peak = {std::max(up_peak, down_peak)};
    figures.beam = span_above(figures.upward ? up : down, 0.5 * figures.peak.value);
    figures.field = span_above(figures.upward ? up : down, 0.1 * figures.peak.value);
    return figures;
}

/// True when every figure of the table equals the intensity in the mirrored plane. At the poles, where
/// all planes meet, there is nothing to compare.
template <class Mirror>
bool is_symmetric(const Photometry& photometry, double tolerance, const Mirror& mirror) {
    const double* candela = photometry.candela.data();
    for (const double plane : photometry.horizontal_deg) {
        for (const double gamma : photometry.vertical_deg) {
            const double value = *candela++;
            if (gamma == 0.0 || gamma == 180.0) continue;
            const Vec3 mirrored = photometric_direction(PhotometricType::C, {mirror(plane), gamma});
            if (std::abs(value - intensity(photometry, mirrored).value) > tolerance) return false;
        }
    }
    return true;
}

PhotometricSymmetry symmetry_found(const Photometry& photometry) {
    if (photometry.type != PhotometricType::C) return photometry.symmetry;
    const double tolerance = 0.01 * peak_intensity(photometry).value;  // measurement repeats to about 1 %
    const auto alike = [&](auto mirror) { return is_symmetric(photometry, tolerance, mirror); };
    const double first = photometry.horizontal_deg.front();
    if (alike([first](double) { return first; })) return PhotometricSymmetry::rotational;
    const bool about_0 = alike([](double plane) { return -plane; });
    const bool about_90 = alike([](double plane) { return 180.0 - plane; });
    if (about_0 && about_90) return PhotometricSymmetry::quadrant;
    if (about_0) return PhotometricSymmetry::plane_0;
    return about_90 ? PhotometricSymmetry::plane_90 : PhotometricSymmetry::none;
}

/// The number a keyword's text begins with.
std::optional<double> leading_number(std::string_view text) {
    double value = 0.0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value, std::chars_format::fixed);
    if (error != std::errc{} || !(value > 0.0) || !std::isfinite(value)) return std::nullopt;
    return value;
}

/// What containers, LM-63 and TM-33 files call the flux of the whole luminaire; the first that is there counts.
constexpr std::string_view flux_keywords[] = {"GLDF rated flux", "_ABSOLUTELUMENS", "_TOTALLUMINAIRELUMENS",
                                              "LuminousFlux"};

std::optional<LuminousFlux> declared_flux(const Photometry& photometry) {
    for (const auto& [key, text] : photometry.keywords) {
        if (std::find(std::begin(flux_keywords), std::end(flux_keywords), key) == std::end(flux_keywords)) continue;
        if (const auto lumens = leading_number(text)) return LuminousFlux{*lumens};
    }
    if (!photometry.declared_output_ratio || photometry.lamp_set >= photometry.lamp_sets.size()) return std::nullopt;
    return LuminousFlux{*photometry.declared_output_ratio * photometry.lamp_sets[photometry.lamp_set].lumens};
}

/// Planes 0 and 360 are one plane of which a file of the full circle has two.
std::optional<double> seam_difference(const Photometry& photometry) {
    const std::vector<double>& planes = photometry.horizontal_deg;
    const double peak = peak_intensity(photometry).value;
    const bool twice = photometry.type == PhotometricType::C && planes.size() > 1 && peak > 0.0 &&
                       std::abs(planes.back() - planes.front() - 360.0) < 1e-3;
    if (!twice) return std::nullopt;
    const std::size_t row = photometry.vertical_deg.size();
    double greatest = 0.0;
    for (std::size_t k = 0; k < row; ++k) {
        const double first = photometry.candela[k];
        greatest = std::max(greatest, std::abs(photometry.candela[photometry.candela.size() - row + k] - first));
    }
    return greatest / peak;
}

std::vector<std::string> differences(const Photometry& photometry, const PhotometryFigures& figures) {
    constexpr double noticed = 0.02;
    std::vector<std::string> sentences;
    if (figures.flux_difference && std::abs(*figures.flux_difference) > noticed) {
        sentences.push_back(fmt::format(
            "The file declares {:.0f} lm; its intensities integrate to {:.0f} lm, a difference of {:+.1f} %.",
            figures.declared_flux->value, figures.flux.value, 100.0 * *figures.flux_difference));
    }
    const auto& share = photometry.declared_downward_share;
    if (share && figures.downward_share && std::abs(*share - *figures.downward_share) > noticed) {
        sentences.push_back(
            fmt::format("The file declares {:.0f} % of the flux downward; its intensities give {:.0f} %.",
                        100.0 * *share, 100.0 * *figures.downward_share));
    }
    if (figures.output_ratio && *figures.output_ratio > 1.0 + noticed) {
        sentences.push_back(
            fmt::format("The luminaire gives {:.0f} % of the light of its lamps.", 100.0 * *figures.output_ratio));
    }
    if (figures.seam_difference && *figures.seam_difference > noticed) {
        sentences.push_back(fmt::format("Planes 0 and 360 are one plane but differ by {:.1f} % of the peak.",
                                        100.0 * *figures.seam_difference));
    }
    if (figures.symmetry_found == PhotometricSymmetry::none && photometry.symmetry != PhotometricSymmetry::none) {
        sentences.emplace_back("The intensities do not have the symmetry that is declared.");
    }
    return sentences;
}

}  // namespace

PhotometryFigures photometry_figures(const Photometry& photometry) {
    if (photometry.quarter_turns != 0) {
        Photometry unturned = photometry;
        unturned.quarter_turns = 0;
        return photometry_figures(unturned);
    }
    PhotometryFigures figures;
    figures.flux = luminous_flux(photometry);
    figures.zone_average_flux = zone_average_flux(photometry);
    figures.declared_flux = declared_flux(photometry);
    if (figures.declared_flux && figures.declared_flux->value > 0.0)
        figures.flux_difference = figures.flux / *figures.declared_flux - 1.0;
    figures.seam_difference = seam_difference(photometry);
    if (photometry.lamp_lumens > 0.0) figures.output_ratio = figures.flux.value / photometry.lamp_lumens;
    if (figures.flux.value > 0.0) figures.downward_share = downward_flux(photometry) / figures.flux;
    if (photometry.input_watts > 0.0) figures.efficacy = figures.flux.value / photometry.input_watts;
    figures.peak = peak_intensity(photometry);
    figures.peak_at = peak_angles(photometry);
    figures.symmetry_found = symmetry_found(photometry);
    figures.plane_0 = plane_figures(photometry, 0.0);
    figures.plane_90 = plane_figures(photometry, 90.0);
    const double far = PointCertificate(photometry).distance_for(point_error);
    if (std::isfinite(far)) figures.point_distance = far;
    figures.differences = differences(photometry, figures);
    return figures;
}

}  // namespace hanei
