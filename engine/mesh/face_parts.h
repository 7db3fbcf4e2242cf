/// What every mesh of a face consists of, however its cells were cut.
#pragma once

#include "engine/mesh/mesh.h"
#include "engine/mesh/place_index.h"

namespace hanei {

/// The patch with a given outline; its corners are numbered in `places`, from the face's first vertex.
/// Its number of face and its material are the caller's.
/// Returns   none for a sliver no wider than `same_place`.
std::optional<Patch> patch_of(const MeshFace& face, const Polygon& outline, PlaceIndex& places, double same_place);

/// Appends the vertices of the face whose patches are the mesh's last, with their shares of area. Of the
/// materials that meet at a vertex, the one with the greatest share is the vertex's; of equal shares the first.
void add_vertices(Mesh& mesh, MeshFace& face, std::span<const Vec3> places);

/// Vertices on one line along the face are a row: lines of the grid, and between them the corners that
/// cuts have left.
std::vector<VertexRow> rows_of(const Mesh& mesh, const MeshFace& face, double same_place);

}  // namespace hanei
