/// What of a solved room is seen through any place of a picture, by rays, without OpenGL.
#pragma once

#include "ui/view/camera.h"
#include "ui/view/cell_field.h"
#include "ui/view/left_out.h"
#include "ui/view/ray_tree.h"

#include <optional>
#include <vector>

namespace hanei {

/// A place of a surface: always within its cell, so that no light leaks in from behind an edge.
struct Seen {
    std::uint32_t cell = 0;  ///< into DisplayMesh::cells
    Vec2 at{0.0};            ///< bilinear coordinates in it
    Vec3 place{0.0};
    double depth = 0.0;  ///< m along the line of sight
};

/// Faces are seen from their lit side only; backs are looked through, as in every picture.
///
/// Holds     the cells that face the eye, under a tree; borrows the solution. Any thread may ask.
/// Cost      1 us a cell to make; about 0.5 us a ray.
class Sight {
public:
    /// Needs     a solution with a mesh and a display mesh.
    Sight(const Solution& solution, const Camera& camera, double aspect);

    /// `at` is 0..1 from the top left. Empty where the background is seen.
    std::optional<Seen> through(const Vec2& at) const;

    const CellFrame& frame(std::uint32_t cell) const { return frames_[index_[cell]]; }

private:
    Ray ray(const Vec2& at) const;  ///< its direction has length 1 along the line of sight

    Ray corner_, right_, down_;
    std::vector<CellFrame> frames_;
    std::vector<std::uint32_t> cells_;  ///< one a frame
    std::vector<std::uint32_t> index_;  ///< one a cell: its frame
    RayTree tree_;
    CutPlanes planes_;
};

}  // namespace hanei
