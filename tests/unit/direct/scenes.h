/// Luminaires and receivers the direct-light tests are made of.
#pragma once

#include "engine/direct/direct.h"
#include "engine/scene/intensity.h"

#include <cmath>
#include <functional>
#include <numbers>

namespace hanei::testing {

inline constexpr double pi = std::numbers::pi;

inline Luminaire luminaire_at(const Vec3& position, const Opening& opening, const Output& output) {
    Luminaire luminaire;
    luminaire.id = ObjectId{7};
    luminaire.position = position;
    luminaire.opening = opening;
    luminaire.output = output;
    return luminaire;
}

inline Receiver floor_point(double x, double y) { return {{x, y, 0}, {0, 0, 1}, Vec3{0}}; }

/// A panel centred on the luminaire, facing down.
inline PolygonOpening panel(double width, double depth) {
    const double x = 0.5 * width, y = 0.5 * depth;
    return {{{{-x, -y, 0}, {-x, y, 0}, {x, y, 0}, {x, -y, 0}}, {}}};
}

/// A rotational table with the intensity f(gamma in radians) every `step` degrees to `last`.
inline Photometry table(const std::function<double(double)>& f, double step, double last = 180) {
    Photometry photometry;
    photometry.id = ObjectId{3};
    photometry.symmetry = PhotometricSymmetry::rotational;
    photometry.horizontal_deg = {0};
    for (double gamma = 0; gamma <= last + 1e-9; gamma += step) {
        photometry.vertical_deg.push_back(gamma);
        photometry.candela.push_back(f(gamma * pi / 180));
    }
    photometry.absolute = true;
    return photometry;
}

inline ConvexBody sheet(const Polygon& outline, std::uint32_t owner = 0) {
    ConvexBody body{outline, {{}}, owner};
    for (std::size_t k = 0; k < outline.size(); ++k) body.faces[0].push_back(static_cast<int>(k));
    return body;
}

}  // namespace hanei::testing
