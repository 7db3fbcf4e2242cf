/// A thin diffuse tube.
#pragma once

#include "engine/geometry/configuration_factor.h"

namespace hanei {

/// An element ds shines I1 sin(a) ds at the angle a to the line. With the foot F of the
/// perpendicular from the point, h = |F|, s counted from F along the unit direction t, r^2 = h^2 + s^2
/// and x twice the angle the tube subtends,
///
///     E = I1 [ h n.F ((x - sin x) / (4 h^3) + (s2 - s1) / (r1 r2)^2)
///            + h n.t (s2 - s1)(s1 + s2) / (2 (r1 r2)^2) ]
///
/// which keeps its digits beside the tube and near its prolongation.
struct LineSource {
    Vec3 from{0.0};
    Vec3 to{0.0};
    double normal_intensity = 0.0;  ///< I1, cd a metre

    /// Illuminance from the part first <= t <= last of the tube (0 at `from`, 1 at `to`), cut at the
    /// receiver's horizon. 0 on the tube itself and on its prolongation.
    double unobstructed(const Receiver& receiver, double first = 0.0, double last = 1.0) const;

    /// The same if all of the tube shone from one place.
    double from_place(const Vec3& place, const Receiver& receiver) const;
};

}  // namespace hanei
