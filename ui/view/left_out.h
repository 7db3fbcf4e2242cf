/// What a picture leaves out of a room: its ceiling, and what lies before a section plane.
#pragma once

#include "engine/geometry/polygon.h"
#include "engine/scene/scene.h"
#include "ui/view/camera.h"

#include <utility>
#include <vector>

namespace hanei {

/// The half spaces that the surfaces of a picture are cut at. Luminaires are cut by the first alone:
/// those of a ceiling that is taken off stay where they hang.
///
/// Holds     the section plane, and a plane a millimetre under the ceiling where that is taken off, so
///           that columns are cut there as by a section.
class CutPlanes {
public:
    CutPlanes() = default;
    CutPlanes(const LeftOut& left_out, const Scene* scene);  ///< no scene: it has no ceiling

    bool keeps(const Vec3& place) const { return is_kept(cut, place) && is_kept(ceiling, place); }
    bool any() const { return cut || ceiling; }

    std::optional<Cut> cut;
    std::optional<Cut> ceiling;

    /// What lies in the plane is kept: a floor that a section lies on is seen.
    static bool is_kept(const std::optional<Cut>& plane, const Vec3& place) {
        return !plane || glm::dot(plane->normal, place) <= plane->offset + 1e-9;
    }
    bool operator==(const CutPlanes&) const = default;
};

/// Where furniture is cut: convex polygons in the plane, turned towards what is left out.
/// Weak when a solid cannot be cut into convex pieces (solids_of): it is open where the plane meets it.
std::vector<Polygon> sections_of(const Scene& scene, const Cut& plane);

/// Where faces of the room and free surfaces are cut.
std::vector<std::pair<Vec3, Vec3>> cut_lines_of(const Scene& scene, const Cut& plane);

/// Whether a ray passes a section of furniture before this distance: nothing is seen behind it.
bool meets_section(const Scene& scene, const CutPlanes& planes, const Ray& ray, double before);

}  // namespace hanei
