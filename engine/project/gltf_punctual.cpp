#include "engine/project/gltf_punctual.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace hanei {
namespace {

constexpr double degrees = 180.0 / std::numbers::pi;

Photometry from_light(std::vector<double> vertical_deg, std::vector<double> candela) {
    Photometry photometry;
    photometry.format = "KHR_lights_punctual";
    photometry.symmetry = PhotometricSymmetry::rotational;
    photometry.horizontal_deg = {0.0};
    photometry.vertical_deg = std::move(vertical_deg);
    photometry.candela = std::move(candela);
    photometry.absolute = true;
    return photometry;
}

}  // namespace

Photometry point_light(double candela) { return from_light({0.0, 180.0}, {candela, candela}); }

Photometry spot_light(double candela, double inner, double outer) {
    constexpr double sharpest = 1e-6;
    inner = std::min(inner, outer - sharpest);
    if (inner < sharpest) inner = 0.0;
    // An interpolant over steps of h misses a curve by h^2/8 of its second derivative, which times
    // the square of outer - inner is 8 at most: 100 steps would keep to 1e-4.
    constexpr int steps = 128;
    std::vector<double> vertical_deg{0.0};
    std::vector<double> figures{candela};
    const double edge = std::cos(outer);
    for (int k = inner > 0.0 ? 0 : 1; k < steps; ++k) {
        const double angle = inner + (outer - inner) * k / steps;
        const double share = std::clamp((std::cos(angle) - edge) / (std::cos(inner) - edge), 0.0, 1.0);
        vertical_deg.push_back(angle * degrees);
        figures.push_back(candela * share * share);
    }
    vertical_deg.push_back(outer * degrees);
    figures.push_back(0.0);
    return from_light(std::move(vertical_deg), std::move(figures));
}

}  // namespace hanei
