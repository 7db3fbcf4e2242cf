/// Rooms such as designers draw, but of any proportions, colours and clutter.
#pragma once

#include "tests/random_scene.h"

namespace hanei::test {

/// A room with a few boxes, from specks to wardrobes, some hanging in the air or standing on each other; up
/// to three luminaires below the ceiling: areas, lines, points; twelve calculation points.
Scene random_room(Dice& dice);

/// What the environment says, or else what is usual.
std::uint64_t number_of(const char* variable, std::uint64_t usual);

}  // namespace hanei::test
