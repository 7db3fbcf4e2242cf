#include "engine/scene/intensity.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <vector>

namespace hanei {
namespace {

// The interpolant is a sum of products of hat functions, one in each angle, so that its integral is a
// double sum over the table with one weight an angle. Of the two angles one is a longitude, whose
// weights are widths, the other a latitude, whose circles shrink towards the poles.

constexpr double degree = std::numbers::pi / 180.0;

enum class Rule { exact, zone_average };

/// The part of the angles that counts, in the table's degrees.
struct Window {
    double low = -360.0;
    double high = 720.0;
};

/// Integrals of the two hat functions over the part of [a, b] inside the window.
struct HatPair {
    double first = 0.0;
    double second = 0.0;
};

HatPair longitude_hats(double a, double b, const Window& window) {
    const double from = std::max(a, window.low);
    const double to = std::min(b, window.high);
    if (!(to > from)) return {};
    const double middle = ((from + to) / 2.0 - a) / (b - a);
    const double width = (to - from) * degree;
    return {width * (1.0 - middle), width * middle};
}

/// The same with the sine of the colatitude, which is `shift_deg` more than the table's angle.
HatPair latitude_hats(double a_deg, double b_deg, double shift_deg, const Window& window, Rule rule) {
    const double a = (a_deg + shift_deg) * degree;
    const double b = (b_deg + shift_deg) * degree;
    const double from = (std::max(a_deg, window.low) + shift_deg) * degree;
    const double to = (std::min(b_deg, window.high) + shift_deg) * degree;
    if (!(to > from)) return {};
    const double whole = std::cos(from) - std::cos(to);
    if (rule == Rule::zone_average) return {whole / 2.0, whole / 2.0};
    const double rising = std::sin(to) - (to - a) * std::cos(to) - std::sin(from) + (from - a) * std::cos(from);
    const double second = rising / (b - a);
    return {whole - second, second};
}

template <class Hats>
std::vector<double> weights(const std::vector<double>& angles, const Hats& hats) {
    std::vector<double> result(angles.size(), 0.0);
    for (std::size_t k = 0; k + 1 < angles.size(); ++k) {
        const HatPair pair = hats(angles[k], angles[k + 1]);
        result[k] += pair.first;
        result[k + 1] += pair.second;
    }
    return result;
}

std::vector<double> longitude_weights(const std::vector<double>& angles, const Window& window) {
    return weights(angles, [&](double a, double b) { return longitude_hats(a, b, window); });
}

std::vector<double> latitude_weights(const std::vector<double>& angles, double shift_deg, const Window& window,
                                     Rule rule) {
    return weights(angles, [&](double a, double b) { return latitude_hats(a, b, shift_deg, window, rule); });
}

double copies(PhotometricSymmetry symmetry) {
    switch (symmetry) {
        case PhotometricSymmetry::none:
        case PhotometricSymmetry::rotational:
            return 1.0;
        case PhotometricSymmetry::plane_0:
        case PhotometricSymmetry::plane_90:
            return 2.0;
        case PhotometricSymmetry::quadrant:
            break;
    }
    return 4.0;
}

std::vector<double> horizontal_weights(const Photometry& photometry, Rule rule) {
    const std::vector<double>& angles = photometry.horizontal_deg;
    const bool is_latitude = photometry.type == PhotometricType::B;
    if (angles.size() == 1) return {is_latitude ? 2.0 : 2.0 * std::numbers::pi};
    std::vector<double> result = is_latitude ? latitude_weights(angles, 90.0, {}, rule) : longitude_weights(angles, {});
    if (photometry.type == PhotometricType::C && photometry.symmetry == PhotometricSymmetry::none) {
        const double gap = (angles.front() + 360.0 - angles.back()) * degree;
        result.front() += gap / 2.0;
        result.back() += gap / 2.0;
    }
    for (double& weight : result) weight *= copies(photometry.symmetry);
    return result;
}

std::vector<double> vertical_weights(const Photometry& photometry, const Window& window, Rule rule) {
    if (photometry.type == PhotometricType::B) return longitude_weights(photometry.vertical_deg, window);
    const double shift = photometry.type == PhotometricType::A ? 90.0 : 0.0;
    return latitude_weights(photometry.vertical_deg, shift, window, rule);
}

LuminousFlux flux(const Photometry& photometry, const Window& vertical, Rule rule) {
    const std::vector<double> across = horizontal_weights(photometry, rule);
    const std::vector<double> along = vertical_weights(photometry, vertical, rule);
    double total = 0.0;
    const double* candela = photometry.candela.data();
    for (const double plane_weight : across) {
        double plane = 0.0;
        for (const double weight : along) plane += weight * *candela++;
        total += plane_weight * plane;
    }
    return {total};
}

/// Vertical angles of directions below the horizontal.
Window below_the_horizontal(PhotometricType type) {
    switch (type) {
        case PhotometricType::A:
            return {-90.0, 0.0};
        case PhotometricType::B:
            return {-90.0, 90.0};
        case PhotometricType::C:
            break;
    }
    return {0.0, 90.0};
}

}  // namespace

LuminousFlux luminous_flux(const Photometry& photometry) { return flux(photometry, {}, Rule::exact); }

LuminousFlux downward_flux(const Photometry& photometry) {
    return flux(photometry, below_the_horizontal(photometry.type), Rule::exact);
}

LuminousFlux zone_average_flux(const Photometry& photometry) { return flux(photometry, {}, Rule::zone_average); }

}  // namespace hanei
