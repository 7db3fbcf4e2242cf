/// Where the luminaires of an arrangement hang.
#pragma once

#include "engine/scene/scene.h"

#include <vector>

namespace hanei {

inline constexpr int most_in_a_row = 200;  ///< places along one side of a layout

struct LayoutPlace {
    Vec3 position{0.0};
    double yaw = 0.0;  ///< rad, on top of the arrangement's own
};

/// Of a line from its first end to its last, of a field row by row from its corner, of a circle from
/// its first angle counter-clockwise. One luminaire of a line hangs in its middle.
///
/// Returns   as many as place_count says.
std::vector<LayoutPlace> places_of(const Layout& layout);
std::size_t place_count(const Layout& layout);  ///< 0 for counts below 1

}  // namespace hanei
