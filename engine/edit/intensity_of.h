/// The intensity of any luminaire of a scene, seen from far away.
#pragma once

#include "engine/scene/scene.h"

namespace hanei {

/// Of a luminaire at full output, measured or not: what its opening sends as a whole, as from a point.
/// A solid opening that is not measured is taken to shine alike all around.
class IntensityOf {
public:
    /// Needs     the scene to outlive it.
    IntensityOf(const Scene& scene, const Luminaire& luminaire);

    /// cd towards a unit direction in the luminaire's own frame.
    double operator()(const Vec3& direction) const;
    double flux() const { return flux_; }  ///< lm

private:
    Luminaire luminaire_;
    const Photometry* photometry_ = nullptr;
    double flux_ = 0.0;
    double scale_ = 1.0;  ///< of the file's candela
    Vec3 axis_{0.0, 0.0, -1.0};
};

}  // namespace hanei
