/// What the lumen method says of a scene, against what was solved.
#pragma once

#include "engine/solution/solution.h"

#include <string>

namespace hanei {

/// The mean illuminance of the whole working plane.
struct LumenPoint {
    double working_plane = 0.0;         ///< m above the floor
    double predicted = 0.0;             ///< lx: sum of flux times utilization factor of all luminaires, over the area
    double solved = 0.0;                ///< lx
    double milliseconds = 0.0;          ///< that the prediction took
    std::string refusal = "not asked";  ///< one sentence why there is none; empty: there is one
    double error() const {
        return solved > 0.0 ? (predicted > solved ? predicted / solved - 1.0 : 1.0 - predicted / solved) : 0.0;
    }
};

/// The lumen method (engine/edit/lumen_method.h) knows the room as a box, three reflectances and
/// luminaires spread evenly; furniture and the very places of the luminaires do not count. The working
/// plane is at the height of the largest horizontal calculation grid, else at 0.75 m; places within
/// furniture are left out of the solved mean.
///
/// Needs     a complete solution.
/// Returns   a refusal without a room, without luminaires, or where surfaces shine by themselves.
LumenPoint lumen_point(const Solution& solution);

}  // namespace hanei
