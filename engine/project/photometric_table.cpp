#include "engine/project/photometric_table.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <utility>

namespace hanei {
namespace {

/// Degrees by which files miss round angles: 89.999 stands for 90.
constexpr double same_angle = 1e-3;

/// Searchlights stay below 1e10 cd. Sums over the table must stay numbers.
constexpr double most_candela = 1e15;

bool is_at(double angle, double round) { return std::abs(angle - round) <= same_angle; }

std::optional<PhotometricSymmetry> known_range(double first, double last) {
    struct Range {
        double first, last;
        PhotometricSymmetry symmetry;
    };
    static constexpr Range ranges[] = {
        {0.0, 90.0, PhotometricSymmetry::quadrant},   {0.0, 180.0, PhotometricSymmetry::plane_0},
        {180.0, 360.0, PhotometricSymmetry::plane_0}, {90.0, 270.0, PhotometricSymmetry::plane_90},
        {-90.0, 90.0, PhotometricSymmetry::plane_90}, {0.0, 360.0, PhotometricSymmetry::none},
        {-180.0, 180.0, PhotometricSymmetry::none},
    };
    for (const Range& range : ranges) {
        if (is_at(first, range.first) && is_at(last, range.last)) return range.symmetry;
    }
    return std::nullopt;
}

/// A gap as wide as the first or the last step is no gap: the plane at 360 is left out.
bool is_a_step(const std::vector<double>& angles, double gap) {
    const std::size_t n = angles.size();
    return is_at(gap, angles[1] - angles[0]) || is_at(gap, angles[n - 1] - angles[n - 2]);
}

std::optional<PhotometricSymmetry> circle_symmetry(const std::vector<double>& angles, int line,
                                                   LuminaireFindings& findings) {
    const double first = angles.front();
    const double last = angles.back();
    if (const auto known = known_range(first, last)) {
        if (first < 0.0) {
            findings.warn(line, "horizontal angles",
                          fmt::format("they run from {} to {}, not upward from 0", first, last));
        }
        return known;
    }
    const double gap = first + 360.0 - last;
    if (is_a_step(angles, gap)) return PhotometricSymmetry::none;
    if (gap > 0.0 && gap <= 90.0) {
        findings.warn(line, "horizontal angles",
                      fmt::format("they run from {} to {}; the gap of {} degrees is interpolated", first, last, gap));
        return PhotometricSymmetry::none;
    }
    findings.fault(
        line, "horizontal angle",
        fmt::format("the angles run from {} to {}; 0 alone, 0 to 90, 0 to 180, 90 to 270 and 0 to 360 are allowed",
                    first, last));
    return std::nullopt;
}

void warn_of_unequal_seam(const Photometry& photometry, int line, LuminaireFindings& findings) {
    const auto& planes = photometry.horizontal_deg;
    const bool closed = photometry.type == PhotometricType::C && photometry.symmetry == PhotometricSymmetry::none &&
                        planes.size() > 1 && is_at(planes.back() - planes.front(), 360.0);
    if (!closed) return;
    const std::size_t row = photometry.vertical_deg.size();
    const double* last = photometry.candela.data() + (planes.size() - 1) * row;
    const double peak = *std::max_element(photometry.candela.begin(), photometry.candela.end());
    double greatest = 0.0;
    for (std::size_t k = 0; k < row; ++k) greatest = std::max(greatest, std::abs(photometry.candela[k] - last[k]));
    constexpr double noticed = 1e-3;  // of the peak: smaller differences are the rounding of the file's figures
    if (greatest > noticed * peak) {
        findings.warn(line, "candela",
                      fmt::format("planes {} and {} are one plane but differ by {:.2g} % of the peak", planes.front(),
                                  planes.back(), 100.0 * greatest / peak));
    }
}

}  // namespace

std::optional<PhotometricSymmetry> symmetry_of(PhotometricType type, const std::vector<double>& horizontal_deg,
                                               int line, LuminaireFindings& findings) {
    if (horizontal_deg.size() == 1) {
        if (type != PhotometricType::C) {
            findings.warn(line, "horizontal angles", "a single one in a file of type A or B stands for all");
        }
        return PhotometricSymmetry::rotational;
    }
    if (type == PhotometricType::C) return circle_symmetry(horizontal_deg, line, findings);
    return is_at(horizontal_deg.front(), 0.0) ? PhotometricSymmetry::plane_0 : PhotometricSymmetry::none;
}

void set_candela(Photometry& photometry, std::vector<double> figures, double factor, int line,
                 LuminaireFindings& findings) {
    if (findings.failed()) return;
    std::size_t negative = 0;
    double least = 0.0;
    for (double& figure : figures) {
        figure *= factor;
        if (!(std::abs(figure) <= most_candela))
            return findings.fault(line, "candela", "the file's factors make a figure greater than 1e15 cd");
        if (figure >= 0.0) continue;
        ++negative;
        least = std::min(least, figure);
        figure = 0.0;
    }
    if (negative > 0) {
        findings.warn(line, "candela",
                      fmt::format("{} negative figures, down to {} cd, are read as 0", negative, least));
    }
    photometry.candela_per_figure = factor;
    photometry.candela = std::move(figures);
    if (std::all_of(photometry.candela.begin(), photometry.candela.end(), [](double value) { return value == 0.0; })) {
        findings.warn(line, "candela", "every figure is 0: the luminaire is dark");
    }
    warn_of_unequal_seam(photometry, line, findings);
}

void check_opening(const MeasuredOpeningSize& opening, int line, LuminaireFindings& findings) {
    constexpr double largest = 20.0;  // m: no luminaire is longer; millimetres written as metres are
    if (std::max({opening.extent_0, opening.extent_90, opening.height}) <= largest) return;
    findings.warn(line, "luminous opening",
                  fmt::format("{} x {} x {} m is larger than any luminaire; millimetres or feet may stand for metres",
                              opening.extent_0, opening.extent_90, opening.height));
}

}  // namespace hanei
