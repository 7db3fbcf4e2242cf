/// What may stand in the way of a source's light.
#pragma once

#include "engine/geometry/occluders.h"

#include <optional>
#include <span>
#include <vector>

namespace hanei {

/// The bodies of a scene without those the source itself is: a flat opening and the faces of a
/// convex solid lie on their own body's surface, which hides nothing of them.
///
/// Holds     borrowed occluders; `among`, when given, are all that can meet the light at hand, found
///           once for many receivers.
struct Obstacles {
    const OccluderSet* occluders = nullptr;  ///< null: none
    std::uint32_t own_body = 0;              ///< ObjectId value of the source; 0 for none
    std::optional<std::span<const BodyIndex>> among;

    /// Writes the bodies that may stand between the eye and the points of a source to `found`.
    void between(const Vec3& eye, std::span<const Vec3> points, std::vector<BodyIndex>& found) const {
        found.clear();
        if (!occluders || occluders->empty()) return;
        if (among) {
            occluders->between(eye, points, *among, found, own_body);
        } else {
            occluders->between(eye, points, found, own_body);
        }
    }
};

}  // namespace hanei
