/// A lit room and photometries that tests of luminaire edits share.
#pragma once

#include "engine/edit/edit.h"

#include <cmath>
#include <numbers>

namespace hanei::test {

/// cos^m about an axis tilted by `towards` (rad) from the nadir to plane C `plane_deg`, of peak 1000 cd.
inline Photometry lobe(double exponent, double towards = 0.0, double plane_deg = 0.0) {
    Photometry photometry;
    photometry.name = "Lobe";
    constexpr double degree = std::numbers::pi / 180.0;
    const double c0 = plane_deg * degree;
    const double axis[] = {std::sin(towards) * std::cos(c0), std::sin(towards) * std::sin(c0), -std::cos(towards)};
    for (int gamma = 0; gamma <= 180; gamma += 5) photometry.vertical_deg.push_back(gamma);
    for (int c = 0; c < 360; c += 10) {
        photometry.horizontal_deg.push_back(c);
        for (const double gamma : photometry.vertical_deg) {
            const double sine = std::sin(gamma * degree);
            const double cosine = axis[0] * sine * std::cos(c * degree) + axis[1] * sine * std::sin(c * degree) -
                                  axis[2] * std::cos(gamma * degree);
            photometry.candela.push_back(cosine > 0.0 ? 1000.0 * std::pow(cosine, exponent) : 0.0);
        }
    }
    photometry.absolute = true;
    photometry.opening = {OpeningShape::rectangle, 1.2, 0.3, 0.0};
    photometry.input_watts = 30.0;
    return photometry;
}

/// The empty room with one luminaire of this photometry below its ceiling.
inline Added hung(Photometry photometry) { return with_measured_luminaire(empty_room(), std::move(photometry)); }

}  // namespace hanei::test
