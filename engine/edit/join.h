/// Two scenes as one: what was imported joins what is there.
#pragma once

#include "engine/scene/scene.h"

namespace hanei {

/// Everything of `from` added to `into`, under new ids. Materials, photometries and control groups that
/// are there already, equal but for their ids, are used again. A room takes the place of the one that is
/// there; title, maintenance factor and colour scale stay those of `into`.
Scene joined(Scene into, const Scene& from);

/// Without all that it shows, lights and computes: title, maintenance factor and colour scale stay, and no id
/// is given twice.
Scene emptied(Scene scene);

/// Moved so that the middle of its footprint stands at this place of the plan and its lowest point on the
/// floor. A scene with a room or without anything that has a place stays where it is.
Scene stood_at(Scene scene, Vec2 place, double floor);

}  // namespace hanei
