/// Where a mesh is too coarse for its light, as a solution on it shows.
#pragma once

#include "engine/mesh/mesh.h"

#include <span>
#include <vector>

namespace hanei {

/// A solution on a mesh, as far as its need of refinement goes.
struct MeshLight {
    std::span<const double> at_vertices;  ///< lx, all that arrives at every vertex
    /// lx, what the solution's elements say: the mean over every patch (constant elements), or the value
    /// at every corner of every patch, in their order, exitance_at over the reflectance (linear ones).
    std::span<const double> of_elements;
    std::span<const double> reflectance;  ///< one a patch
    /// One a patch: how much 1 lm/m2 more on it matters. Empty: its area. Best for the mean relative
    /// error of calculation points was the sum of its share of all area, over the points' mean
    /// illuminance, and of the points' mean of (form factor x visible share / the point's illuminance).
    std::span<const double> importance;
};

/// How much light may be misplaced within every patch: importance x reflectance x (greatest - least) of
/// 0 and what the elements miss at the corners. A patch half in shadow, or half hidden from what it
/// lights, stands out by it: what is seen of it from a lit place is mostly its lit part, and a mean over
/// it loses that light.
///
/// Returns   0 where nothing is reflected, or for a value that is not finite.
/// Weak when light or shadow lies within a patch and touches no corner: only the patch's mean tells of it.
std::vector<double> refinement_need(const Mesh& mesh, const MeshLight& light);

/// The patches of greatest need, as many as make `new_patches` more when cut (`refined`); of equal need
/// the first. Patches without need, or too thin to be cut, are left whole.
///
/// From 300 patches two rounds to 1000 are as good as four. A last round needs no balance: the exitance
/// of its patches can be gathered from the mesh before.
/// Returns   one flag a patch.
std::vector<char> patches_to_split(const Mesh& mesh, std::span<const double> need, std::size_t new_patches);

}  // namespace hanei
