#pragma once

#include "engine/geometry/occluders.h"

#include <span>
#include <vector>

namespace hanei {

/// Bodies that may stand between the eye and the points of a source, without those the source
/// itself is (`own_body`; 0 for none): a flat opening and the faces of a convex solid lie on their
/// own body's surface, which hides nothing of them.
inline void candidates(const OccluderSet& occluders, const Vec3& eye, std::span<const Vec3> points,
                       std::uint32_t own_body, std::vector<BodyIndex>& found) {
    found.clear();
    if (occluders.empty()) return;
    occluders.between(eye, points, found);
    if (own_body == 0) return;
    std::erase_if(found, [&](BodyIndex body) { return occluders.bodies()[body].owner == own_body; });
}

}  // namespace hanei
