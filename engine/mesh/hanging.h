/// Vertices that one side of an edge has and the other has not.
#pragma once

#include "engine/mesh/mesh.h"

#include <vector>

namespace hanei {

/// A vertex in the middle of a patch's edge (a T-junction). A picture interpolated patch by patch is
/// without a jump there when the vertex shows `(1 - share) x from + share x to`.
struct HangingVertex {
    VertexId vertex;
    VertexId from, to;   ///< ends of the edge, corners of the patch on its coarser side
    double share = 0.0;  ///< place on the edge, 0 to 1
};

/// Needs     nothing else; furniture's footprints make hanging vertices as refinement does.
/// Returns   in such an order that `from` and `to`, when they hang themselves, come before. Where
///           edges hang on each other in a ring, one of them keeps its own value.
/// Cost      a look at the patches around every vertex.
std::vector<HangingVertex> hanging_vertices(const Mesh& mesh);

}  // namespace hanei
