/// Light from surfaces as it was last known, to show with a scene's own direct light until its answer is
/// there: close to it after a small change, and never without interreflection.
#pragma once

#include "engine/mesh/mesh.h"
#include "engine/study/display_stage.h"

#include <memory>

namespace hanei {

class CarriedLight {
public:
    /// `flux`, lm, is what all luminaires emitted.
    void keep(std::shared_ptr<const Mesh> mesh, LightOfSurfaces light, double flux);

    bool empty() const { return mesh_ == nullptr; }

    /// What was kept, in proportion to the flux emitted. At a vertex that another mesh did not have: among
    /// the nearest of its face; on a face that it did not have: the mean of all.
    /// Needs     something kept.
    LightOfSurfaces at(const std::shared_ptr<const Mesh>& mesh, double flux) const;

private:
    std::shared_ptr<const Mesh> mesh_;
    LightOfSurfaces light_;
    double flux_ = 0.0;
};

}  // namespace hanei
