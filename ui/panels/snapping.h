/// Where moved objects catch: the raster, walls, centre lines of the room, and other objects.
#pragma once

#include "engine/edit/several.h"

#include <string>

namespace hanei {

struct SnapSettings {
    bool on = true;
    double raster = 0.1;  ///< m, 0.01 to 1
    bool to_raster = true;
    bool to_walls = true;    ///< touching them; luminaires also at half their spacing from them
    bool to_centre = true;   ///< the middle of the room's plan
    bool to_objects = true;  ///< in line with others of its kind
    double raster_now() const { return on && to_raster ? raster : 0.0; }  ///< m; 0: none
    bool operator==(const SnapSettings&) const = default;
};

enum class SnapKind { wall, half_spacing, centre, object };

/// A value that the moved object's x (axis 0) or y (axis 1) catches at.
struct SnapLine {
    int axis = 0;
    double value = 0.0;
    SnapKind kind = SnapKind::object;
    double source = 0.0;  ///< along the axis: the wall; along the other one: the object in line
};

/// The lines for objects that are moved together and held at `place`.
/// Cost      linear in the objects and the plan's edges.
std::vector<SnapLine> snap_lines(const Scene& scene, std::span<const ObjectId> moving, const Vec3& place,
                                 const SnapSettings& settings);

struct Snapped {
    Vec3 place{0.0};
    std::vector<SnapLine> caught;  ///< one an axis at most
};

/// The place that is meant by `wished`: in x and y the nearest line within `reach` (m), else the
/// raster; in z the raster. Axes that are not free stay as they are.
///
/// Needs     reach >= 0.
Snapped snapped(const Vec3& wished, std::span<const SnapLine> lines, const SnapSettings& settings, double reach,
                const bool (&free)[3]);

/// "Snap 0.1 m", "Free".
std::string text_of(const SnapSettings& settings);

}  // namespace hanei
