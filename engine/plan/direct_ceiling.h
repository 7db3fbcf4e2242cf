/// How much direct light a luminaire can bring to a coarse cell at most.
#pragma once

#include "engine/plan/ceiling_cells.h"

namespace hanei {

/// Of a luminaire at full output, with nothing in the way.
class DirectCeiling {
public:
    DirectCeiling(const Scene& scene, const Luminaire& luminaire);

    /// lx on any place of the cell. Infinite where a luminaire of known intensity touches it.
    double on(const CeilingCell& cell) const;

    const CeilingCell& shining() const { return shining_; }  ///< what light comes from
    double intensity() const { return intensity_; }          ///< cd, the greatest; 0 of diffuse openings

private:
    bool touches(const CeilingCell& cell) const;
    double half_turned(const CeilingCell& cell) const;

    CeilingCell shining_;
    double exitance_ = 0.0;   ///< lm/m2 of a diffuse opening
    double intensity_ = 0.0;  ///< cd of any other
    double upward_ = 0.0;     ///< cd, the greatest in the plane of the opening and behind it
    Vec3 axis_{0.0, 0.0, -1.0};
};

}  // namespace hanei
