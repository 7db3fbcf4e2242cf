/// The patches of one face as a receiver sees them: every corner and every edge worked out once,
/// though up to four patches share it.
#pragma once

#include "engine/mesh/mesh.h"

#include <cstdint>
#include <span>
#include <vector>

namespace hanei {

/// Where a face lies as a whole for a receiver.
enum class FaceSeen {
    hidden,   ///< behind the receiver's horizon, or turned away
    wholly,   ///< in front and above the horizon
    partly,   ///< cut by the horizon
    touching  ///< the receiver lies in its plane: only patches that reach it may be seen, as a limit
};

/// Bounds in the coordinates of a face: u along its grid, v across.
struct FlatBox {
    double low_u = 0.0, low_v = 0.0, high_u = 0.0, high_v = 0.0;

    bool meets(const FlatBox& other) const {
        return low_u <= other.high_u && other.low_u <= high_u && low_v <= other.high_v && other.low_v <= high_v;
    }
};

/// What of a face does not depend on the receiver.
struct FaceLayout {
    struct Edge {
        std::uint32_t from = 0, to = 0;  ///< vertices, counted within the face
    };
    const MeshFace* face = nullptr;
    std::vector<Vec3> corners;              ///< of a convex polygon that all patches lie in
    std::vector<Vec3> vertices;             ///< places, counted within the face
    std::vector<Edge> edges;                ///< each once, whichever way patches run along it
    std::vector<std::int32_t> edges_of;     ///< k + 1 for edge k as listed, -(k + 1) for its reverse
    std::vector<std::uint32_t> first_edge;  ///< into edges_of, one a patch and one past the end
    Vec3 along{0.0}, across{0.0};           ///< u and v are products with these
    std::vector<FlatBox> boxes;             ///< one a patch
    std::vector<FlatBox> group_boxes;       ///< one for every group_size patches
    double same_place = 0.0;                ///< m

    static constexpr std::uint32_t group_size = 16;
};

std::vector<FaceLayout> layouts_of(const Mesh& mesh);

FaceSeen seen_from(const FaceLayout& layout, const Receiver& receiver);

/// True when the receiver (in the plane of the face) lies on the patch's bounds.
bool reaches(const Patch& patch, const Vec3& place, double same_place);

}  // namespace hanei
