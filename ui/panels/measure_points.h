/// Where a measuring tool catches: corners, centres and edges of what is seen, else the raster.
#pragma once

#include "engine/scene/faces.h"
#include "ui/panels/pane.h"

#include <optional>
#include <vector>

namespace hanei {

enum class Catch { corner, centre, edge, raster, none };

struct MeasurePoint {
    Vec3 place{0.0};
    Catch caught = Catch::none;
};

/// What of a scene can be caught.
struct MeasureMarks {
    struct Edge {
        Vec3 from{0.0}, to{0.0};
    };
    std::vector<Vec3> corners, centres;
    std::vector<Edge> edges;
};
/// Corners and edges of all faces, doors and windows among them; centres of luminaires, of calculation points
/// and of furniture, on its top.
MeasureMarks measure_marks(const Scene& scene);

/// The mark within `reach` pixels of the pointer: a corner or centre before an edge, and of those the
/// nearest to the pointer; of two in one place the one nearer to the eye. Else where the ray meets a face,
/// on the raster (m; 0: none) but in the face. What the picture leaves out is not caught.
///
/// Returns   nothing when the pointer meets nothing. `catches` false: faces alone, without the raster.
std::optional<MeasurePoint> measure_point(const Scene& scene, const MeasureMarks& marks, const Pane& pane, ImVec2 at,
                                          double raster, float reach, bool catches);

}  // namespace hanei
