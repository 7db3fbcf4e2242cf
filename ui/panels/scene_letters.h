/// The letters that a project's own texts need.
#pragma once

#include "engine/scene/scene.h"

namespace hanei {

/// Asks style::needs() for the letters of every name and title in the scene.
/// Cost      a look at each letter; nothing for letters that are there.
void need_letters_of(const Scene& scene);

}  // namespace hanei
