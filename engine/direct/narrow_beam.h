/// A cone of light that the nodes of a patch may lie beside, all of them.
#pragma once

#include "engine/base/vector.h"

namespace hanei {

struct NarrowBeam {
    Vec3 from{0.0};
    Vec3 axis{0.0, 0.0, -1.0};  ///< unit
    double half_angle = 0.0;    ///< rad, at which the intensity is half of that along the axis
};

}  // namespace hanei
