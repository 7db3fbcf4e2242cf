/// What follows from a luminaire's photometry, beside what its file declares.
#pragma once

#include "engine/scene/intensity.h"
#include "engine/scene/photometry.h"

#include <optional>
#include <string>
#include <vector>

namespace hanei {

/// Angles from the pole (nadir or zenith) at which the intensity of a plane falls to a share of the
/// plane's peak: the outermost ones of the hemisphere the peak lies in. Positive towards the plane
/// itself, negative towards the opposite one.
struct AngleSpan {
    double from_deg = 0.0, to_deg = 0.0;
    bool cut = false;  ///< the light is still above the share at the horizontal
    double width_deg() const { return to_deg - from_deg; }
};

/// A plane through the vertical: C0-C180 or C90-C270.
struct PlaneFigures {
    double plane_deg = 0.0;
    LuminousIntensity peak;
    bool upward = false;             ///< the peak lies above the horizontal: angles count from the zenith
    std::optional<AngleSpan> beam;   ///< 50 % of the plane's peak; empty in a dark plane
    std::optional<AngleSpan> field;  ///< 10 %
};

/// What taking an opening for a point may cost at most, of peak intensity / distance squared.
inline constexpr double point_error = 0.005;

struct PhotometryFigures {
    LuminousFlux flux;                          ///< integral of the bilinear interpolant
    LuminousFlux zone_average_flux;             ///< as North American reports print
    std::optional<LuminousFlux> declared_flux;  ///< of the luminaire, where the file states one
    std::optional<double> flux_difference;      ///< flux / declared_flux - 1
    std::optional<double> seam_difference;      ///< of planes 0 and 360, of the peak, where the file has both
    std::optional<double> output_ratio;         ///< flux over lamp flux; empty for absolute photometry
    std::optional<double> downward_share;       ///< of the flux; empty for a dark luminaire
    std::optional<double> efficacy;             ///< lm/W; empty without watts
    LuminousIntensity peak;
    PhotometricAngles peak_at;                                       ///< in the file's own angles
    PhotometricSymmetry symmetry_found = PhotometricSymmetry::none;  ///< of type C, to 1 % of the peak
    PlaneFigures plane_0, plane_90;
    std::optional<double> point_distance;  ///< m, from where on the opening may be taken for a point (point_error)
    std::vector<std::string> differences;  ///< above 2 % between declared and computed, one sentence each
};

/// Planes are the file's own: quarter turns against the housing change no figure.
PhotometryFigures photometry_figures(const Photometry& photometry);

}  // namespace hanei
