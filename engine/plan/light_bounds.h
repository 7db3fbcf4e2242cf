/// How strong the light of a scene can be at most, from its description alone.
#pragma once

#include "engine/scene/faces.h"

#include <span>

namespace hanei {

/// Rigorous, and no better than needed for a decision. Infinite where a luminaire touches a surface.
struct LightBounds {
    double flux = 0.0;               ///< lm, of all luminaires, dimmed and maintained
    double direct = 0.0;             ///< lx straight from luminaires on any surface
    double own_exitance = 0.0;       ///< lm/m2, the greatest of any surface
    double reflectance = 0.0;        ///< the greatest of any face or sub-area, in any colour band
    int luminaires = 0;              ///< that give light
    int luminaires_with_extent = 0;  ///< of these, those that are no points

    bool is_dark() const { return luminaires == 0 && own_exitance <= 0.0; }
    /// lm/m2 that leave any surface at most before the first interreflection.
    double first_exitance() const;
    /// lx that all interreflections after the first `bounces` add at any point, at most: every one
    /// keeps at most the greatest reflectance of what there was.
    double interreflected_after(int bounces) const;
};

LightBounds light_bounds(const Scene& scene, std::span<const Face> faces);

}  // namespace hanei
