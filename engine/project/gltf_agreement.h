/// Whether the triangles of a file still show what was written.
#pragma once

#include "engine/geometry/triangle_soup.h"
#include "engine/project/gltf_pieces.h"
#include "engine/scene/placement.h"

namespace hanei {

/// The label of triangles is the id of their material.
void append(TriangleSoup& soup, const TriangleList& list, const Placement& placed, ObjectId material);

/// The same surfaces with the same labels, in whatever order, and cut into triangles in whatever way
/// between the same corners: every corner of one lies near a corner of the other, and of every label area,
/// vector area and volume are the same. Near is a hundredth of a millimetre, and far from the origin what
/// single precision leaves.
///
/// Needs     corners that count vertices, all of them finite.
/// Weak when a corner of one was cut away that lay within a straight edge: the two are then not the same.
/// Cost      n log n.
bool show_the_same(const TriangleSoup& a, const TriangleSoup& b);

}  // namespace hanei
