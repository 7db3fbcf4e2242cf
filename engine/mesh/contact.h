/// What lies against what: solids, sheets and opaque openings, and the parts of a face they cover.
#pragma once

#include "engine/geometry/occluders.h"
#include "engine/mesh/caps.h"
#include "engine/mesh/cells.h"
#include "engine/scene/faces.h"

#include <optional>
#include <vector>

namespace hanei {

/// Everything of a scene that can cover a face or cast a shadow, in scene coordinates.
///
/// Which of two things in one plane is seen:
///   - a solid standing on a face covers it, and is covered by it where they touch;
///   - a solid through a face covers what is inside it;
///   - a free surface on a solid's face covers that, whichever way it looks;
///   - of two sheets (free surfaces, room faces) looking the same way the later-listed is seen;
///   - a sheet with its front against a room face covers it and is covered;
///   - two free surfaces back to back are both seen;
///   - an opaque opening covers what it lies on.
class Contacts {
public:
    explicit Contacts(const Scene& scene);

    const std::vector<Face>& faces() const { return faces_; }
    const std::vector<SolidBody>& solids() const { return solids_; }
    const std::vector<ConvexBody>& openings() const { return openings_; }
    double same_place() const { return same_place_; }  ///< m
    bool is_of_room(std::size_t face) const { return is_of_room_[face]; }
    /// One of the solids whose surface it is, into solids(); -1 for a sheet.
    int solid_of(std::size_t face) const { return solid_of_[face]; }

    /// Convex polygons in the plane of a face that cover it; they may overlap and reach beyond it.
    std::vector<Polygon> covers_of(std::size_t face) const;

    /// Where sheets that are not in the plane of a face stand on it or go through it: a patch across
    /// such a line would lie on both sides of the sheet. And the edges of flat opaque openings that
    /// hang closely over the face: a patch across would be dark on one side and bright on the other.
    std::vector<Crease> creases_of(std::size_t face) const;

private:
    std::vector<Face> faces_;
    std::vector<std::vector<Polygon>> pieces_;  ///< convex, one list a face
    std::vector<bool> is_of_room_;
    std::vector<int> solid_of_;
    std::vector<SolidBody> solids_;
    std::vector<ConvexBody> openings_;
    double same_place_ = 0.0;

    std::optional<Polygon> section(std::size_t face, const ConvexBody& solid) const;
    bool is_skin_of(std::size_t face, std::size_t solid) const;  ///< of the body the solid is part of
    bool solid_covers(std::size_t face, const SolidBody& solid, int number) const;
    bool sheet_covers(std::size_t face, std::size_t sheet) const;
};

/// Opaque luminaire openings in scene coordinates: polygons and measured flat openings as flat
/// bodies, polyhedra as solids. Owner is the luminaire.
std::vector<ConvexBody> opaque_openings(const Scene& scene);

}  // namespace hanei
