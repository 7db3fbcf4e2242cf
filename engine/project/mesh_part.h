/// A solid of a foreign file as a part of furniture.
#pragma once

#include "engine/scene/scene.h"

namespace hanei {

/// The shape as an upright box with its place and its turn, an eighth of a full one at most; as it is when
/// it is none.
Part part_of(SolidShape shape, ObjectId material);

}  // namespace hanei
