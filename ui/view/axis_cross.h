/// Which way x, y and z run in a picture: a small cross of arms with letters.
#pragma once

#include "ui/view/camera.h"

#include <array>

namespace hanei {

/// The end of an arm.
struct AxisMark {
    int axis = 0;        ///< 0 x, 1 y, 2 z
    bool ahead = true;   ///< the end with the letter; the other one is where the axis comes from
    Vec2 at{0.0};        ///< right and down from the middle, in arms
    double depth = 0.0;  ///< -1 nearest to the eye, 1 farthest
    char letter() const { return static_cast<char>('X' + axis); }
};

/// The farthest first, as they are drawn over each other.
std::array<AxisMark, 6> axis_marks(const Camera& camera);

}  // namespace hanei
