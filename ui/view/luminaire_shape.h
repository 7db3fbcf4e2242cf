/// What of a luminaire is seen: its luminous opening in the room.
#pragma once

#include "engine/scene/scene.h"

#include <optional>
#include <utility>
#include <vector>

namespace hanei {

struct LuminaireShape {
    std::vector<Polygon> shining;                ///< convex, counter-clockwise seen from where they shine
    std::vector<std::pair<Vec3, Vec3>> outline;  ///< edges worth drawing
    std::optional<std::pair<Vec3, Vec3>> tube;   ///< a line source
    std::optional<Vec3> point;                   ///< a source without extent
};

/// Round openings become 32-sided ones: they are looked at here, not computed with.
LuminaireShape shape_of(const Luminaire& luminaire, const Scene& scene);

}  // namespace hanei
