#include "ui/panels/photometry_curves.h"

#include "engine/scene/intensity.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace hanei {
namespace {

constexpr double degree = std::numbers::pi / 180.0;
constexpr int steps_a_degree = 2;
constexpr double same_angle = 1e-6;  // degrees: angles of a file that repeat a step are not drawn twice

std::vector<double> sorted_apart(std::vector<double> angles) {
    std::sort(angles.begin(), angles.end());
    const auto same = [](double a, double b) { return std::abs(a - b) < same_angle; };
    angles.erase(std::unique(angles.begin(), angles.end(), same), angles.end());
    return angles;
}

}  // namespace

double candela_at(const Photometry& photometry, double plane_deg, double gamma_deg) {
    const PhotometricAngles angles{gamma_deg < 0.0 ? plane_deg + 180.0 : plane_deg, std::abs(gamma_deg)};
    return intensity(photometry, photometric_direction(PhotometricType::C, angles)).value;
}

std::vector<CurvePoint> plane_curve(const Photometry& photometry, double plane_deg) {
    std::vector<double> gammas;
    for (int step = -180 * steps_a_degree; step <= 180 * steps_a_degree; ++step) {
        gammas.push_back(static_cast<double>(step) / steps_a_degree);
    }
    if (photometry.type == PhotometricType::C) {
        for (const double gamma : photometry.vertical_deg) gammas.insert(gammas.end(), {gamma, -gamma});
    }
    std::vector<CurvePoint> curve;
    for (const double gamma : sorted_apart(std::move(gammas))) {
        curve.push_back({gamma, candela_at(photometry, plane_deg, gamma)});
    }
    return curve;
}

std::vector<double> offered_planes(const Photometry& photometry) {
    std::vector<double> planes;
    if (photometry.type != PhotometricType::C) {
        for (int k = 0; k < 12; ++k) planes.push_back(15.0 * k);
        return planes;
    }
    if (photometry.symmetry == PhotometricSymmetry::rotational) return {0.0};
    planes = {0.0, 90.0};
    for (const double plane : photometry.horizontal_deg) {
        for (const double mirrored : {plane, -plane}) {
            const double folded = std::fmod(mirrored + 720.0, 180.0);
            if (folded < 180.0 - same_angle) planes.push_back(folded);
        }
    }
    return sorted_apart(std::move(planes));
}

double per_kilolumen(const Photometry& photometry) {
    const double lumens = photometry.absolute || !(photometry.lamp_lumens > 0.0) ? luminous_flux(photometry).value
                                                                                 : photometry.lamp_lumens;
    return lumens > 0.0 ? 1000.0 / lumens : 0.0;
}

double ring_step(double peak) {
    if (!(peak > 0.0) || !std::isfinite(peak)) return 1.0;
    const double decade = std::pow(10.0, std::floor(std::log10(peak)));
    const double leading = peak / decade;  // 1 to 10
    if (leading < 1.5) return 0.2 * decade;
    if (leading < 3.0) return 0.5 * decade;
    return leading < 7.0 ? decade : 2.0 * decade;
}

bool shines_upward(const std::vector<CurvePoint>& curve, double peak) {
    return std::any_of(curve.begin(), curve.end(), [peak](const CurvePoint& point) {
        return std::abs(point.gamma_deg) > 90.0 && point.candela > 0.01 * peak;
    });
}

Vec2 PolarFrame::at(double gamma_deg, double value) const {
    const double out = radius * value / full;
    return centre + out * Vec2(std::sin(gamma_deg * degree), std::cos(gamma_deg * degree));
}

double PolarFrame::gamma_deg(Vec2 place) const {
    const Vec2 out = place - centre;
    return out == Vec2(0.0) ? 0.0 : std::atan2(out.x, out.y) / degree;
}

}  // namespace hanei
