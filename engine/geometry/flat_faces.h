/// Triangles that lie in one plane joined to the polygons that somebody once drew.
#pragma once

#include "engine/geometry/triangle_shells.h"

namespace hanei {

struct FlatFace {
    std::vector<int> loop;                ///< vertex numbers, counter-clockwise seen from the front
    std::vector<std::vector<int>> holes;  ///< clockwise
    int label = 0;                        ///< that of most of its area
    double area = 0.0;                    ///< m2
};

struct FlatFaceRules {
    bool holes = false;        ///< else a face with a hole is cut into faces without
    bool keep_labels = false;  ///< triangles of different labels stay apart
    double distance = 0.0;     ///< m: a corner this near to the line of its neighbours is none
};

/// Faces of a shell. Every loop is simple and as flat as tolerance::planar asks. Corners that lie on a
/// line in every face they belong to are left out, so that a closed shell stays closed.
///
/// Needs     a shell of shells_of().
/// Returns   faces in the order of their largest triangles, larger ones first. Where joining fails (an
///           outline that crosses itself) the triangles themselves.
/// Cost      n log n, and the square of the corners of the greatest face.
std::vector<FlatFace> flat_faces(const TriangleShell& shell, const FlatFaceRules& rules);

/// The corners of a loop.
Polygon polygon_of(const std::vector<Vec3>& vertices, const std::vector<int>& loop);

/// In coordinates of its own plane, x and y to the right and up for somebody in front of it.
std::vector<Vec2> flattened(const Polygon& polygon, const Vec3& normal);

}  // namespace hanei
