/// Where the exitance is unknown: the nodes of the patches.
#pragma once

#include "engine/mesh/mesh.h"
#include "engine/transport/patch_frame.h"

#include <array>
#include <span>
#include <vector>

namespace hanei {

/// How the exitance runs over a patch.
enum class Elements {
    constant,  ///< one value, asked for in the middle
    linear     ///< four values, bilinear between them and on to the edges; patches need not agree there
};

/// Nodes of patch p are [p x per_patch, (p + 1) x per_patch); of four, bit 0 of a node's number is set
/// on the far side along the patch's first axis, bit 1 along its second (PatchFrame).
struct Nodes {
    Elements elements = Elements::constant;
    std::size_t per_patch = 1;
    std::vector<Receiver> receivers;
    std::vector<double> areas;  ///< m2 that a node's value stands for in the patch's mean

    std::size_t size() const { return receivers.size(); }
    std::size_t patches() const { return receivers.size() / per_patch; }
    /// Needs linear elements.
    PatchFrame frame(std::size_t patch) const;
};
Nodes nodes_of(const Mesh& mesh, Elements elements);

/// Mean over every patch of what has these values at the nodes.
/// Holds     exact for the elements' functions.
std::vector<double> patch_means(const Nodes& nodes, std::span<const double> node_values);

/// The value at a place of a patch, its edges included; never below 0, which the line through the
/// nodes may reach at an edge.
double exitance_at(const Mesh& mesh, const Nodes& nodes, PatchId patch, const Vec3& place,
                   std::span<const double> node_values);

/// For every vertex of the mesh the mean over the patches that meet there of their values there; for
/// pictures.
std::vector<double> vertex_values(const Mesh& mesh, const Nodes& nodes, std::span<const double> node_values);

/// The four parts of a patch that a quantity is averaged over before it is given to linear elements.
std::array<Polygon, 4> quarters_of(const Mesh& mesh, const Nodes& nodes, PatchId patch);

/// Values at a patch's four nodes from the means over its quarters: by least squares, exact for a
/// bilinear quantity on a rectangle and for a linear one on any patch.
/// Needs     means of 0 or more.
/// Returns   0 or more: a slope that would go below is made flatter.
/// Holds     the patch's mean, so that no light is lost or won.
std::array<double, 4> node_values_of_quarters(const Mesh& mesh, const Nodes& nodes, PatchId patch,
                                              const std::array<double, 4>& means);

}  // namespace hanei
