/// Free surfaces that together enclose a convex solid, possibly standing open where they touch
/// something: a box without its bottom, a table leg without its ends.
#pragma once

#include "engine/geometry/occluders.h"
#include "engine/scene/faces.h"

#include <optional>
#include <span>
#include <vector>

namespace hanei {

/// A convex solid and the faces of the scene that are its surface.
struct SolidBody {
    ConvexBody body;                 ///< closed: the missing faces of a cap are among its faces
    std::vector<std::size_t> faces;  ///< indices into the faces of the scene, ascending
    /// Number of the shell it is part of, none for a cap: solids of one shell are one body.
    std::optional<std::size_t> shell;
};

/// Caps among the free surfaces of `faces`.
///
/// A cap hides what its convex hull hides: every face has all the others behind it, what is missing
/// is flat and convex, at most one missing face is open (every other is covered by faces lying in
/// its plane), and nothing of the scene is inside. A sight line between two places outside then
/// passes the hull exactly when it meets one of the cap's faces.
std::vector<SolidBody> convex_caps(const Scene& scene, std::span<const Face> faces, double same_place);

}  // namespace hanei
