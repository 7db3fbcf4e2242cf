/// The curves a luminaire is judged by, before they are drawn: values, scales and places.
///
/// A plane stands for a pair of half planes: gamma counts from straight down, positive within plane C
/// and negative within C + 180.
#pragma once

#include "engine/base/vector.h"
#include "engine/scene/photometry.h"

#include <vector>

namespace hanei {

struct CurvePoint {
    double gamma_deg = 0.0;  ///< -180 to 180
    double candela = 0.0;
};

/// Intensity along a plane: every half degree, and every angle of the file's own table.
///
/// Needs     a table that hangs together (intensity.h). Planes are the luminaire's: counted with its
///           quarter turns.
std::vector<CurvePoint> plane_curve(const Photometry& photometry, double plane_deg);

/// Intensity towards a signed gamma of a plane.
double candela_at(const Photometry& photometry, double plane_deg, double gamma_deg);

/// Planes worth offering, 0 to below 180 degrees: those of the file, its symmetry unfolded; every 15 degrees
/// where the file's planes are of another kind. One plane alone when the light is rotational.
std::vector<double> offered_planes(const Photometry& photometry);

/// By what candela are multiplied to become cd/klm: per 1000 lm of the lamps, or of the luminaire
/// where its photometry is absolute. 0 for a dark luminaire.
double per_kilolumen(const Photometry& photometry);

/// The distance of rings or grid lines: 1, 2 or 5 times a power of ten, three to seven of them up to the peak.
double ring_step(double peak);

/// More than a hundredth of the peak goes above the horizontal: a half circle would not show it.
bool shines_upward(const std::vector<CurvePoint>& curve, double peak);

/// Where a polar diagram lies on the screen: x right, y down, straight down is down.
struct PolarFrame {
    Vec2 centre{0.0};
    double radius = 1.0;  ///< pixels
    double full = 1.0;    ///< the value at the radius

    Vec2 at(double gamma_deg, double value) const;
    double gamma_deg(Vec2 place) const;  ///< -180 to 180; 0 at the centre itself
};

}  // namespace hanei
