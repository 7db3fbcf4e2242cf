/// A finer mesh: some patches of another one cut up.
#pragma once

#include "engine/mesh/mesh.h"

#include <functional>

namespace hanei {

struct RefinedMesh {
    std::shared_ptr<const Mesh> mesh;
    std::vector<PatchId> origin;  ///< one a patch of `mesh`: the patch of the coarser mesh that it is, or is part of
};

/// Flagged patches are cut through the middle, along and across their face's grid: in four, or in two
/// across their length when they are twice as long as wide; where a cut would leave a sliver beside a
/// corner, it goes through that corner. Other patches stay as they are, and every patch keeps its
/// place in the order: the parts stand where the patch stood, one after another.
///
/// Needs     one flag a patch; 0 leaves it whole.
/// Holds     every patch is a convex polygon of one material that light can reach; vertices of the
///           coarser mesh keep place, direction and order within their face, new ones follow them.
/// Weak when neighbours are cut unequally: the middle of the coarser one's edge is then a vertex of
///           the finer ones only.
/// Cost      about that of making the finer mesh.
RefinedMesh refined(const Mesh& coarse, std::span<const char> split);

/// A mesh that has given parts of another one's patches for patches: for questions asked of parts, such as
/// which share of every part is visible. A part too thin to be a patch is stood for by the whole patch.
///
/// Needs     convex parts that fill their patch, wound as it, at least one of each.
/// Holds     one patch a part, in the order of patches and of their parts.
using PatchParts = std::function<std::vector<Polygon>(PatchId)>;
RefinedMesh in_parts(const Mesh& coarse, const PatchParts& parts);

/// The parts into which `refined` cuts a convex polygon, each with its winding; in rows along `along`.
/// Needs     a convex polygon in the plane of two unit vectors at right angles.
std::vector<Polygon> parts_of(const Polygon& patch, const Vec3& along, const Vec3& across, double same_place);

}  // namespace hanei
