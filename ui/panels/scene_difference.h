#pragma once

#include "engine/scene/scene.h"

#include <string>

namespace hanei {

/// What was done to `before` to make `after`, in a few words: "2 luminaires added, 1 changed; room
/// changed". "Nothing" when they are equal.
std::string difference_text(const Scene& before, const Scene& after);

}  // namespace hanei
