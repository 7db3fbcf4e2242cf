/// What a study will cost, in milliseconds: areas, and a few figures measured on one core of 2020.
#pragma once

#include "engine/plan/settings.h"
#include "engine/scene/faces.h"

#include <span>

namespace hanei {

/// Predictions of the plan. Good to a factor of three: enough to see what is worth skipping.
struct CostModel {
    double width = 0.0;      ///< m, of patches
    double patches = 0.0;    ///< sum over faces of area / width^2, at least 1 each
    double receivers = 0.0;  ///< patches, and points of grids
    double luminaires = 0.0;
    double obstacles = 0.0;  ///< opaque bodies
    double threads = 1.0;

    static double patches_of(double area, double width);  ///< at least 1

    double direct_ms() const;  ///< all luminaires, no shadow tests
    double direct_occlusion_ms() const;
    double factors_ms() const;  ///< a row a receiver
    double patch_occlusion_ms() const;
    double bounces_ms(int bounces) const;
};

CostModel cost_model(const Scene& scene, const Settings& settings, std::span<const Face> faces);

}  // namespace hanei
